#include "haptics/control/InverseKinematics.h"

#include <algorithm>

#include "device/redundancy/DriftCorrection.h"
#include "device/redundancy/JointLimiter.h"
#include "haptics/control/SelfMotionLimit.h"

namespace haptiv {

InverseKinematics::InverseKinematics(const DeviceDescription& description, double period)
    : arm_(description),
      resolution_(description),
      reach_(description),
      rateLimit_(description.drives.rateLimit),
      driftGain_(description.control.driftGain),
      period_(period) {}

InverseKinematics::Motion InverseKinematics::operator()(const ResolutionChoice& choice, const Pose& wanted,
                                                        const Vector6& twist, const Joints& joints,
                                                        ResolutionBlend& blend) const noexcept {
  const ArmPose arm = arm_.evaluate(joints.angles);
  Motion motion;
  Pose target = wanted;
  Vector6 possible = twist;
  possible.head<3>() = reach_(joints.angles, arm, twist.head<3>());
  const Vector3 ahead = wanted.position - arm.X_BT.position;
  const double distance = ahead.norm();
  if (distance > kLeash) {
    const Vector3 outwards = ahead / distance;
    motion.heldBack = (distance - kLeash) * outwards;
    target.position -= motion.heldBack;
    possible.head<3>() -= std::max(0.0, possible.head<3>().dot(outwards)) * outwards;
  }
  const Vector6 corrected = possible + driftCorrection(target, arm.X_BT, driftGain_);
  JointVector rates = blend.rates(resolution_, choice, joints.angles, arm.J_BT, corrected, period_);
  rates = SelfMotionLimit::calmed(rates, joints.rates, arm.J_BT, period_);
  motion.share = slowDownFactor(rates, rateLimit_);
  motion.rates = motion.share * rates;
  motion.velocity = motion.share * possible.head<3>();
  return motion;
}

}  // namespace haptiv
