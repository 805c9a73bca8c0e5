#pragma once

#include "haptics/tick/HapticTick.h"

namespace haptiv {

/// The walls that are compared.
enum class WallVariant {
  law,         ///< damping while moving in alone, as the law has it (26), (27)
  hysteresis,  ///< and hysteresis of a fifth of the depth at which the hand rests
  bothWays,    ///< damping also while moving out
  passivity,   ///< the law, and time-domain passivity control
};
inline constexpr WallVariant kWallVariants[] = {WallVariant::law, WallVariant::hysteresis, WallVariant::bothWays,
                                                WallVariant::passivity};
const char* nameOf(WallVariant variant);

/// How a hand holds the handle and presses.
struct Grip {
  const char* name;
  double stiffness;  ///< [N/m]
  double damping;    ///< [N s/m]
  double press;      ///< against the wall, at rest [N]
};
inline constexpr Grip kGrips[] = {{"light", 200, 10, 5}, {"firm", 1500, 40, 20}};

/// A wall that is touched.
struct WallTrial {
  WallVariant variant = WallVariant::law;
  Grip grip = kGrips[0];
  double damping = 0;      ///< b [N s/m]
  double stiffness = 0;    ///< k [N/m]
  std::uint64_t seed = 1;  ///< of the sensor's noise
};

/// What came of it.
struct WallOutcome {
  bool isStable = false;
  /// In the last quarter of a second, of the hand's force or the wall's, whichever is larger: peak to peak about its
  /// straight line, along the normal [N]; infinite where a fault stopped the arm or the contact was lost.
  double oscillation = 0;
  std::uint64_t ticks = 0;
};

/// A hand that brings the simulated arm 30 mm to a wall at 0.1 m/s, presses, and rests: the whole chain, from encoders
/// to drives. Deterministic.
///
/// Stable: 1.6 s after the start, no fault stands, the ball touches the wall through the last quarter of a second, and
/// the oscillation then is no larger than kCalm, or has fallen to less than 0.8 of what it was 0.45 s before. A trial
/// ends early where the first look finds less than a quarter of kCalm.
class WallTouch {
 public:
  static constexpr double kCalm = 1;         ///< [N], peak to peak
  static constexpr double kApproach = 0.03;  ///< [m]
  static constexpr double kMass = 2;         ///< of the virtual mass [kg]

  /// Throws what SimulatedDevice throws.
  WallTouch(DeviceDescription description, double rate);

  /// Thread-safe: yes.
  WallOutcome operator()(const WallTrial& trial) const;

 private:
  HapticScene sceneOf(const WallTrial& trial) const;

  DeviceDescription description_;
  double rate_;
  HapticTick tick_;
};

}  // namespace haptiv
