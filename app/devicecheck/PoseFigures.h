#pragma once

#include "app/devicecheck/Specification.h"
#include "device/described/DeviceDescription.h"
#include "device/kinematics/ArmPose.h"

namespace haptiv {

/// What the arm can do in one pose.
struct PoseFigures {
  double sigmaTranslation = 0;  ///< smallest singular value of J's upper half [m]
  double sigmaRotation = 0;     ///< of its lower half [1]
  double manipulability = 0;    ///< w = sqrt(det(J J^T)), eq. (6) [m^3]
  double indexTranslation = 0;  ///< V / kappa of the upper half, eq. (14) [m^3]
  double indexRotation = 0;     ///< of the lower half [1]
  double force = 0;             ///< that every direction can have [N]
  double pitchYawTorque = 0;    ///< that every axis across the tool's x can have [N m]
  double rollTorque = 0;        ///< about the tool's x [N m]
  double speed = 0;             ///< that every direction can have [m/s]
};

/// Forces and torques, tau = J^T f, go as far as the first joint's torque limit, after its Coulomb friction and the
/// payload's weight and the links'. Each is asked for alone. Speeds, qdot = J# v of eq. (3), go as far as the first
/// joint's rate limit.
///
/// @param weight  torques that hold the links in this pose, g(q); zero where the description has no bodies [N m]
PoseFigures figuresOf(const ArmPose& arm, const JointVector& weight, const DeviceDescription& device,
                      const Specification& specification);

}  // namespace haptiv
