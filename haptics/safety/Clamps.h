#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "device/DeviceDescription.h"

namespace haptiv {

/// Which of the host's clamps hold something back in a tick; bits. None is a fault by itself.
enum Clamp : std::uint32_t {
  kNoClamp = 0,
  kClampForce = 1u << 0,         ///< of the scene on the ball
  kClampTorque = 1u << 1,        ///< of the scene on the handle
  kClampSpeed = 1u << 2,         ///< of the tool
  kClampAcceleration = 1u << 3,  ///< by which the tool becomes faster
  kClampJointRate = 1u << 4,     ///< a joint would have to turn faster than its drive can
  kClampJointTorque = 1u << 5,   ///< a drive would have to give more than it can
};
inline constexpr int kClampCount = 6;

/// Names of the clamps that hold: "force", "torque", "speed", "acceleration", "joint rate", "joint torque".
std::vector<std::string> clampNames(std::uint32_t clamps);

/// The host's clamps, before anything is written to the device. They are always on; how far they let go stands in the
/// description, [safety] and [drives].
///
/// Each is continuous in what it clamps: what goes in without a step comes out without one. Each sets its bit where it
/// holds something back. What is no number passes, for the check that follows.
/// Realtime-safe: yes, all of it.  Thread: servo.
class Clamps {
 public:
  Clamps(const DeviceDescription& description, double period);

  /// The scene's force, no longer than forceClamp; its direction stays [N].
  Vector3 force(const Vector3& force, std::uint32_t& clamps) const noexcept;
  /// The scene's torque, no longer than torqueClamp; its direction stays [N m].
  Vector3 torque(const Vector3& torque, std::uint32_t& clamps) const noexcept;
  /// The tool's velocity, no faster than speedClamp, and faster than a tick ago by no more than accelerationClamp; its
  /// direction stays. What slows the tool down is never held back: it would only let it deeper into a wall.
  /// @param before  a tick ago, in W [m/s]
  /// @param wanted  now, in W [m/s]
  /// @param scale   of the device in the scene: the clamps are those of the tool at the device
  Vector3 velocity(const Vector3& before, const Vector3& wanted, double scale, std::uint32_t& clamps) const noexcept;
  /// Set-points within what each drive can.
  void command(DeviceCommand& command, std::uint32_t& clamps) const noexcept;

 private:
  SafetyThresholds safety_;
  JointVector rateLimit_, torqueLimit_;
  double period_;
};

}  // namespace haptiv
