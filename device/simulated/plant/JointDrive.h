#pragma once

#include <algorithm>

namespace haptiv {

/// What a drive can do; one joint's share of JointDrives.
struct DriveSettings {
  double rate = 6.28;       ///< largest set-point [rad/s]
  double torque = 60;       ///< largest of the motor, at the joint [N m]
  double inertia = 1;       ///< at the joint, for which its velocity loop is tuned [kg m^2]
  double bandwidth = 400;   ///< of that loop, with that inertia [rad/s]
  double brakeDamping = 0;  ///< of the motor when it is bypassed, at the joint [N m s/rad]
};

/// Torque of a motor over the rate w that its joint will have at the end of a step:
///   tau = offset - slope w, within +-limit
/// It falls with w, so that a step can be solved for w however steep it is.
struct TorqueLaw {
  double offset = 0;  ///< [N m]
  double slope = 0;   ///< [N m s/rad], not negative
  double limit = 0;   ///< [N m]

  double at(double rate) const noexcept { return std::clamp(offset - slope * rate, -limit, limit); }
};

/// A motor with its amplifier and its velocity loop; not the joint that it turns.
///
///   rate     tau = I bandwidth (w_set - w) + d
///            d follows what the last steps took beyond I w' [N m]: weight, friction, the other joints, the hand. With
///            the inertia I that it is tuned for, the joint follows a rate as a low-pass of first order, and a constant
///            load moves it by load / (I bandwidth observer), the observer of d being twice as quick as the loop.
///   torque   tau = tau_set
///   braked   tau = -brakeDamping w: the motor is shorted through a resistor, which bounds the brake
/// All within +-torque. A drive whose rate loop is switched on starts from the torque that holds the arm's weight.
/// Realtime-safe: yes.
class JointDrive {
 public:
  explicit JointDrive(const DriveSettings& settings) : settings_(settings) {}

  /// @param setPoint  wanted rate [rad/s], finite
  /// @param weight    torque that holds the joint where it is [N m]
  TorqueLaw rate(double setPoint, double weight) noexcept;
  /// @param setPoint  wanted torque [N m], finite
  TorqueLaw torque(double setPoint) noexcept;
  TorqueLaw brake() noexcept;

  /// What came of it: the motor's torque [N m] and the joint's acceleration [rad/s^2] in a step of dt [s].
  void moved(double torque, double acceleration, double dt) noexcept;

 private:
  DriveSettings settings_;
  bool holdsRate_ = false;
  double load_ = 0;  // d [N m]
};

}  // namespace haptiv
