#include "haptics/control/InverseKinematics.h"

#include "device/redundancy/DriftCorrection.h"
#include "device/redundancy/JointLimiter.h"

namespace haptiv {

InverseKinematics::InverseKinematics(const DeviceDescription& description, double period)
    : arm_(description),
      resolution_(description),
      rateLimit_(description.drives.rateLimit),
      driftGain_(description.control.driftGain),
      period_(period) {}

InverseKinematics::Motion InverseKinematics::operator()(const ResolutionChoice& choice, const Pose& wanted,
                                                        const Vector6& twist, const JointVector& q,
                                                        ResolutionBlend& blend) const noexcept {
  const ArmPose arm = arm_.evaluate(q);
  const Vector6 corrected = twist + driftCorrection(wanted, arm.X_BT, driftGain_);
  const JointVector rates = blend.rates(resolution_, choice, q, arm.J_BT, corrected, period_);
  const double share = slowDownFactor(rates, rateLimit_);
  return {share * rates, share};
}

}  // namespace haptiv
