#pragma once

#include "device/described/DeviceDescription.h"
#include "device/dynamics/ArmDynamics.h"
#include "haptics/measuring/Measured.h"

namespace haptiv {

/// What the joints are to do at an instant.
struct JointMotion {
  JointVector angles = JointVector::Zero();         ///< [rad]
  JointVector rates = JointVector::Zero();          ///< [rad/s]
  JointVector accelerations = JointVector::Zero();  ///< [rad/s^2]
};

/// Computed torque: the rigid-body model makes of the arm ten masses that do not know of each other, and each is led
/// back to its way as a damped oscillator                                                  [paper, section IV.A]
///
///   tau = M(q) (qdd_d + Kd (qd_d - qd) + Kp (q_d - q)) + C(q, qd) qd + g(q) + r(qd_d) - J^T w_hand
///   Kp = w^2, Kd = 2 zeta w;   r = viscous qd_d + coulomb tanh(qd_d / kSliding)
/// with natural frequency w, damping ratio zeta and the joints' friction of the description. The friction is that of
/// the desired rates: in the way of a feedback it would shake. The hand's wrench, which the sensor tells, is carried by
/// the drives: the arm yields to the hand as the admittance says, and not by its error.
class ComputedTorque {
 public:
  static constexpr double kSliding = 0.02;  ///< from here on friction is taken to be that of sliding [rad/s]

  /// Throws std::runtime_error where the description has no bodies: what needs them, and what to do.
  explicit ComputedTorque(const DeviceDescription& description);

  /// Torques of the drives [N m], unlimited.
  /// @param hand_B  wrench of the hand on the handle [N, N m]
  /// Realtime-safe: yes.
  JointVector operator()(const JointMotion& desired, const Measured& measured, const Wrench& hand_B) const noexcept;

 private:
  ArmDynamics dynamics_;
  JointVector viscous_;
  JointVector coulomb_;
  double stiffness_;  ///< Kp [1/s^2]
  double damping_;    ///< Kd [1/s]
};

}  // namespace haptiv
