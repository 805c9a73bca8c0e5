#pragma once

#include "device/described/DeviceDescription.h"

namespace haptiv {

/// What the display does to the hand, as it is seen for swings.
struct Swinging {
  Vector3 velocity = Vector3::Zero();  ///< of the virtual mass, at the device [m/s]
  Vector3 force = Vector3::Zero();     ///< of the scene on the ball [N]
  double energy = 0;                   ///< of the passivity observer [J]
};

/// What is remembered of a vector that may swing.
struct SwingState {
  Vector3 mean = Vector3::Zero();  ///< behind the low-pass of kSlowest
  Vector3 side = Vector3::Zero();  ///< of the mean on which it was when it last changed sides
  double time = 0;                 ///< since then [s]
  double lately = 0;               ///< mean square of the swing, over kLately
  double before = 0;               ///< the same, over kBefore
};

struct OscillationState {
  bool started = false;
  SwingState velocity, force;
  double energyLately = 0, energyBefore = 0;  ///< means [J]
  double time = 0;                            ///< for which it has swung by itself [s]
};

/// Finds a contact, or a grip, that is not stable: it swings, does not die down, and no hand makes it.
///
/// Swings: what a high-pass of kSlowest leaves of the velocity, or of the scene's force, changes sides at kSlowest or
/// more often, with the mean square of a swing of `oscillationSpeed`, or of kForceShare of `forceClamp`. No shape is
/// asked for: a contact that is far too stiff swings between nothing and the clamp, each time otherwise.
/// Does not die down: the mean square is kKeeps or more of what it was before. What rings after an impact loses more.
/// No hand makes it: either the ball swings about one place, faster than it goes on; or the display feeds it, as the
/// passivity observer says, which is below zero and falls. A ball that is drawn over a rough ground goes on, and swings
/// on what the hand gives.
/// Told once all that has stood for kLongest, less the time in which it has not.
class OscillationMonitor {
 public:
  static constexpr double kSlowest = 10;       ///< [Hz]
  static constexpr double kForceShare = 0.05;  ///< of forceClamp
  static constexpr double kLately = 0.05;      ///< [s]
  static constexpr double kBefore = 0.2;       ///< [s]
  static constexpr double kKeeps = 0.7;        ///< of the mean square
  static constexpr double kLongest = 0.5;      ///< [s]

  OscillationMonitor(const SafetyThresholds& safety, double period);

  /// kFaultOscillation, or none. Realtime-safe: yes.
  std::uint32_t operator()(const Swinging& now, OscillationState& state) const noexcept;

 private:
  bool swings(const Vector3& now, double leastSquare, SwingState& state) const noexcept;

  double leastVelocitySquare_, leastForceSquare_, period_;
  double fastShare_, latelyShare_, beforeShare_;  ///< by which the low-passes follow in a tick
};

}  // namespace haptiv
