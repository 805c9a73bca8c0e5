#include "haptics/control/SelfMotionLimit.h"

#include "device/redundancy/matrices/PseudoInverse.h"

namespace haptiv {

JointVector SelfMotionLimit::calmed(const JointVector& wanted, const JointVector& before, const Jacobian& J,
                                    double period) noexcept {
  const JointVector change = wanted - before;
  if (change.cwiseAbs().maxCoeff() <= kSpeedUp * period) return wanted;
  const PseudoInverse<6, kJointCount> inverse(J, JointVector::Ones());
  const JointVector selfMotion = inverse.nullSpacePart(change);
  const bool slows = selfMotion.dot(inverse.nullSpacePart(before)) < 0;
  const double most = (slows ? kSlowDown : kSpeedUp) * period;
  const double largest = selfMotion.cwiseAbs().maxCoeff();
  return largest <= most ? wanted : JointVector(wanted - (1 - most / largest) * selfMotion);
}

}  // namespace haptiv
