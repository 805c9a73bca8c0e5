#pragma once

#include "device/DeviceDescription.h"
#include "device/dynamics/ArmDynamics.h"
#include "haptics/Measured.h"

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
///   tau = M(q) (qdd_d + Kd (qd_d - qd) + Kp (q_d - q)) + C(q, qd) qd + g(q) - J^T w_hand,   Kp = w^2, Kd = 2 zeta w
/// with natural frequency w and damping ratio zeta of the description. The hand's wrench, which the sensor tells, is
/// carried by the drives: the arm yields to the hand as the admittance says, and not by its error.
class ComputedTorque {
 public:
  /// Throws std::runtime_error where the description has no bodies: what needs them, and what to do.
  explicit ComputedTorque(const DeviceDescription& description);

  /// Torques of the drives [N m], unlimited.
  /// @param hand_B  wrench of the hand on the handle [N, N m]
  /// Realtime-safe: yes.
  JointVector operator()(const JointMotion& desired, const Measured& measured, const Wrench& hand_B) const noexcept;

 private:
  ArmDynamics dynamics_;
  double stiffness_;  ///< Kp [1/s^2]
  double damping_;    ///< Kd [1/s]
};

}  // namespace haptiv
