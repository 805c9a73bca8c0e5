#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "device/described/DeviceDescription.h"

namespace haptiv {

/// Which of the host's clamps hold something back in a tick; bits. None is a fault by itself.
enum Clamp : std::uint32_t {
  kNoClamp = 0,
  kClampForce = 1u << 0,         ///< of the scene on the ball
  kClampTorque = 1u << 1,        ///< of the scene on the handle
  kClampSpeed = 1u << 2,         ///< that the tool is sent on with
  kClampAcceleration = 1u << 3,  ///< by which the tool becomes faster
  kClampJointRate = 1u << 4,     ///< a joint would have to turn faster than its drive can
  kClampJointTorque = 1u << 5,   ///< a drive would have to give more than it can
  kClampCorrection = 1u << 6,    ///< by which the joint controller would make the tool too fast
};
inline constexpr int kClampCount = 7;

/// Names of the clamps that hold: "force", "torque", "speed", "acceleration", "joint rate", "joint torque",
/// "correction".
std::vector<std::string> clampNames(std::uint32_t clamps);

/// The host's clamps, before anything is written to the device. They are always on; how far they let go stands in the
/// description, [safety] and [drives].
///
/// Each is continuous in what it clamps: what goes in without a step comes out without one. Each sets its bit where it
/// holds something back. What is no number passes, for the check that follows.
/// Realtime-safe: yes, all of it.  Thread: servo.
class Clamps {
 public:
  /// Of speedClamp, which the tool must not exceed, so much is sent at the most: what is left is for drives that yield
  /// and for faults until they are found (ToolSpeedMonitor, EncoderMonitor).
  static constexpr double kSentShare = 0.85;

  Clamps(const DeviceDescription& description, double period);

  /// The scene's force, no longer than forceClamp; its direction stays [N].
  Vector3 force(const Vector3& force, std::uint32_t& clamps) const noexcept;
  /// The scene's torque, no longer than torqueClamp; its direction stays [N m].
  Vector3 torque(const Vector3& torque, std::uint32_t& clamps) const noexcept;
  /// The tool's velocity, no faster than kSentShare of speedClamp, and faster than a tick ago by no more than
  /// accelerationClamp; its direction stays. What slows the tool down is never held back: it would only let it deeper
  /// into a wall.
  /// @param before  a tick ago, in W [m/s]
  /// @param wanted  now, in W [m/s]
  /// @param scale   of the device in the scene: the clamps are those of the tool at the device
  Vector3 velocity(const Vector3& before, const Vector3& wanted, double scale, std::uint32_t& clamps) const noexcept;
  /// Set-points within what each drive can, and rates, the controller's corrections included, that move the tool no
  /// faster than the velocity above.
  /// @param J_BT  where the arm is
  void command(DeviceCommand& command, const Jacobian& J_BT, std::uint32_t& clamps) const noexcept;

 private:
  SafetyThresholds safety_;
  double sentSpeed_;  ///< of the tool at the device [m/s]
  JointVector rateLimit_, torqueLimit_;
  double period_;
};

}  // namespace haptiv
