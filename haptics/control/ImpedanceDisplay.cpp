#include "haptics/control/ImpedanceDisplay.h"

#include "device/redundancy/DriftCorrection.h"
#include "device/redundancy/matrices/PseudoInverse.h"

namespace haptiv {

ImpedanceDisplay::ImpedanceDisplay(const DeviceDescription& description)
    : control_(description.control),
      selfMotionDamping_(description.control.selfMotionDamping * description.drives.inertia) {
  if (!description.bodies.links.empty()) dynamics_.emplace(description);
}

JointVector ImpedanceDisplay::operator()(const Measured& measured, const Wrench& onTool) const noexcept {
  const Jacobian& J = measured.arm.J_BT;
  Vector6 wrench;
  wrench << onTool.force, onTool.torque;
  const PseudoInverse<6, kJointCount> inverse(J, JointVector::Ones());
  const JointVector selfMotion = inverse.nullSpacePart(measured.rates);
  JointVector torques = J.transpose() * wrench;
  torques -= inverse.nullSpacePart(selfMotionDamping_.cwiseProduct(selfMotion));
  if (dynamics_) torques += dynamics_->gravity(measured.angles);
  return torques;
}

Vector3 ImpedanceDisplay::holding(const Matrix3& held, const Measured& measured) const noexcept {
  const Vector3 rate = measured.arm.J_BT.bottomRows<3>() * measured.rates;
  const Pose wanted{measured.arm.X_BT.position, held};
  const Vector3 back = driftCorrection(wanted, measured.arm.X_BT, control_.orientationStiffness).tail<3>();
  return back - control_.orientationDamping * rate;
}

Vector3 ImpedanceDisplay::loose(const Measured& measured) const noexcept {
  return -control_.rotationalDamping * (measured.arm.J_BT.bottomRows<3>() * measured.rates);
}

}  // namespace haptiv
