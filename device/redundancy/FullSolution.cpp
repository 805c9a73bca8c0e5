#include "device/redundancy/FullSolution.h"

#include "device/redundancy/criterion/CriterionGradient.h"

namespace haptiv {

FullSolution::FullSolution(const Jacobian& J, const JointVector& squaredWeights,
                           const ControlSettings& control) noexcept
    : J_(J), squaredWeights_(squaredWeights), inverse_(J, squaredWeights) {
  inverse_.damp(control.singularityDamping, 1 - inverse_.manipulability() / control.singularityThreshold);
}

CriterionPair FullSolution::values(Strategy strategy) const noexcept {
  const Matrix3 translation = inverse_.gram().topLeftCorner<3, 3>();
  const Matrix3 rotation = inverse_.gram().bottomRightCorner<3, 3>();
  return {criterionValue<3>(strategy, BlockEigen<3>(translation).sigma, Corners::sharp),
          criterionValue<3>(strategy, BlockEigen<3>(rotation).sigma, Corners::sharp)};
}

JointVector FullSolution::selfMotion(Strategy strategy, const CriterionPair& weights) const noexcept {
  const Matrix3 translation = inverse_.gram().topLeftCorner<3, 3>();
  const Matrix3 rotation = inverse_.gram().bottomRightCorner<3, 3>();
  const JointVector v =
      translationalGradient(strategy, J_, squaredWeights_, BlockEigen<3>(translation), Corners::rounded);
  const JointVector w = rotationalGradient(strategy, J_, squaredWeights_, BlockEigen<3>(rotation), Corners::rounded);
  return inverse_.nullSpacePart(weights.translation * v + weights.rotation * w);
}

}  // namespace haptiv
