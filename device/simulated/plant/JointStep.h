#pragma once

#include <array>

#include "device/dynamics/ArmDynamics.h"
#include "device/simulated/plant/JointDrive.h"

namespace haptiv {

/// A step of time for all joints together, the motors, the gears' friction and the links pulling at each other:
///
///   M (w - w0) = dt (tau(w) + load - viscous w - f),   |f| <= coulomb where w = 0, f = coulomb sign(w) elsewhere
/// for the rates w at its end. Implicit, so that brakes and loops may be as stiff as they are; dry friction holds a
/// joint quite still, and does not make it chatter. The w that solves it is the only one: the torques fall with w.
struct JointStep {
  JointMatrix mass;                        ///< M [kg m^2]
  JointVector rates;                       ///< w0 [rad/s]
  JointVector load;                        ///< other torques: of the hand, less the bias b [N m]
  JointVector viscous;                     ///< friction [N m s/rad]
  JointVector coulomb;                     ///< [N m]
  std::array<TorqueLaw, kJointCount> law;  ///< tau, of the motors
  double dt = 0;                           ///< [s]

  /// w [rad/s]. Realtime-safe: yes.
  JointVector solve() const noexcept;
};

}  // namespace haptiv
