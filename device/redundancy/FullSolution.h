#pragma once

#include "device/control/ResolutionChoice.h"
#include "device/redundancy/criterion/CriterionPair.h"
#include "device/redundancy/matrices/PseudoInverse.h"

namespace haptiv {

/// All joints serve all of the motion, eqs. (3)-(5): at one pose of the arm.
///
/// Least norm is damped where the manipulability w = sqrt(det(J J^T)), eq. (6), is below control.singularityThreshold.
/// w mixes metres and radians: the threshold belongs to the arm, so it stands in its description.
/// Realtime-safe: yes.  Never NaN for finite input.
class FullSolution {
 public:
  /// @param squaredWeights  c_k^2 of the joints, eqs. (7), (8)
  FullSolution(const Jacobian& J, const JointVector& squaredWeights, const ControlSettings& control) noexcept;

  /// Rates for a twist of the tool, in B.
  JointVector leastNorm(const Vector6& twist) const noexcept { return inverse_.leastNorm(twist); }
  /// Rates that the solution needs for itself, besides the twist: none.
  JointVector upkeep() const noexcept { return JointVector::Zero(); }
  /// Values of a criterion, for the 3x10 blocks of J.
  CriterionPair values(Strategy strategy) const noexcept;
  /// N grad H with H = w.translation C_trans + w.rotation C_rot: leaves the tool where it is.
  JointVector selfMotion(Strategy strategy, const CriterionPair& weights) const noexcept;

 private:
  const Jacobian& J_;
  JointVector squaredWeights_;
  PseudoInverse<6, kJointCount> inverse_;
};

}  // namespace haptiv
