#pragma once

namespace haptiv {

/// What a drive can do; one joint's share of JointDrives.
struct DriveLimits {
  double rate = 6.28;      ///< [rad/s]
  double torque = 60;      ///< [N m]
  double inertia = 1;      ///< at the joint [kg m^2]
  double bandwidth = 400;  ///< of the velocity loop [rad/s]
  double viscous = 0;      ///< friction at the joint [N m s/rad]
  double coulomb = 0;      ///< [N m]
};

/// A velocity-controlled drive with its joint: rate set-point to angle is of second order.
///
///   I w' = tau + tau_load - tau_friction,   tau_friction = viscous w + coulomb sign(w)
///   tau = I bandwidth (w_set - w) - tau_load + tau_friction within +-torque,   w_set within +-rate
/// The loop carries load and friction as far as its torque goes; what exceeds that moves the joint.
class JointDrive {
 public:
  JointDrive(const DriveLimits& limits, double angle) : limits_(limits), angle_(angle) {}

  /// @param setPoint  wanted rate [rad/s]; one that is not finite is taken for zero, which brakes
  /// @param load      torque of the outside on the joint [N m]
  /// @param dt        [s]; stable for every one
  /// Realtime-safe: yes.
  void advance(double setPoint, double load, double dt) noexcept;

  double angle() const noexcept { return angle_; }    ///< [rad]
  double rate() const noexcept { return rate_; }      ///< [rad/s]
  double torque() const noexcept { return torque_; }  ///< of the motor at the joint, in the last step [N m]

 private:
  DriveLimits limits_;
  double angle_;
  double rate_ = 0;
  double torque_ = 0;
};

}  // namespace haptiv
