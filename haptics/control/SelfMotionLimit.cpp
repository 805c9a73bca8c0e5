#include "haptics/control/SelfMotionLimit.h"

#include "device/redundancy/PseudoInverse.h"

namespace haptiv {

JointVector withCalmSelfMotion(const JointVector& wanted, const JointVector& before, const Jacobian& J,
                               double period) noexcept {
  const JointVector change = wanted - before;
  const double most = kMostSelfMotion * period;
  if (change.cwiseAbs().maxCoeff() <= most) return wanted;
  const JointVector selfMotion = PseudoInverse<6, kJointCount>(J, JointVector::Ones()).nullSpacePart(change);
  const double largest = selfMotion.cwiseAbs().maxCoeff();
  return largest <= most ? wanted : JointVector(wanted - (1 - most / largest) * selfMotion);
}

}  // namespace haptiv
