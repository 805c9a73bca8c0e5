#include "device/redundancy/RedundancyResolution.h"

#include <algorithm>

#include "device/kinematics/ArmKinematics.h"
#include "device/redundancy/FullSolution.h"
#include "device/redundancy/Normalisation.h"
#include "device/redundancy/PartitionedSolution.h"
#include "device/redundancy/StepBounds.h"
#include "device/redundancy/ToolDisplacement.h"
#include "device/redundancy/criterion/JacobianDerivative.h"

namespace haptiv {
namespace {

JointVector squaredWeights(const DeviceDescription& description) {
  if (!description.redundancy.weighByRateLimits) return JointVector::Ones();
  const JointVector& limit = description.drives.rateLimit;
  return (limit / limit.maxCoeff()).cwiseAbs2();
}

double stepOf(const StepLengths& steps, Strategy strategy) {
  switch (strategy) {
    case Strategy::man:
      return steps.man;
    case Strategy::dir:
      return steps.dir;
    case Strategy::cond:
      return steps.cond;
    case Strategy::nonopt:
      break;
  }
  return 0;
}

}  // namespace

RedundancyResolution::RedundancyResolution(const DeviceDescription& description)
    : control_(description.control),
      rateLimit_(description.drives.rateLimit),
      squaredWeights_(squaredWeights(description)),
      isPartitionable_(ArmKinematics(description).vishard10() != nullptr) {
  for (const Solution solution : kSolutions) {
    if (solution == Solution::partitioned && !isPartitionable_) continue;
    for (const Strategy strategy : kStrategies) {
      prepared_[static_cast<std::size_t>(solution)][static_cast<std::size_t>(strategy)] =
          prepare(description, {strategy, solution});
    }
  }
}

RedundancyResolution::Prepared RedundancyResolution::prepare(const DeviceDescription& description,
                                                             const ResolutionChoice& choice) const {
  const RedundancySettings& settings = description.redundancy;
  const bool isFull = choice.solution == Solution::full;
  const double sign = choice.strategy == Strategy::cond ? -1 : 1;
  Prepared prepared;
  prepared.step = stepOf(isFull ? settings.stepFull : settings.stepPartitioned, choice.strategy);
  prepared.normalisation = normalisation(description, choice, squaredWeights_);
  prepared.weights = {sign * settings.translationWeight / prepared.normalisation.translation,
                      sign * settings.rotationWeight / prepared.normalisation.rotation};
  return prepared;
}

const RedundancyResolution::Prepared& RedundancyResolution::prepared(const ResolutionChoice& choice) const noexcept {
  const bool isPartitioned = choice.solution == Solution::partitioned && isPartitionable_;
  const auto strategy = std::min<std::size_t>(static_cast<std::size_t>(choice.strategy), kStrategies.size() - 1);
  return prepared_[isPartitioned ? 1 : 0][strategy];
}

template <typename At>
JointVector RedundancyResolution::compose(const At& solution, Strategy strategy, const Prepared& prepared,
                                          const Jacobian& J, const Vector6& twist, double period) const noexcept {
  JointVector leastNorm = solution.leastNorm(twist) + solution.upkeep();
  // x(t + T) = x + T J qdot + T^2/2 Jdot qdot: the last is taken off the twist.
  if (period > 0) leastNorm -= solution.leastNorm(period / 2 * toolAcceleration(J, leastNorm));
  if (strategy == Strategy::nonopt) return leastNorm;

  const JointVector selfMotion = solution.selfMotion(strategy, prepared.weights);
  const StepBounds bounds = stepBounds(leastNorm, selfMotion, rateLimit_);
  JointVector rates = leastNorm + boundedStep(prepared.step, bounds) * selfMotion;
  if (!(period > 0)) return rates;
  // Newton's method; each step leaves a thousandth of the error.
  const Vector6 wanted = toolDisplacement(J, period * leastNorm);
  for (int i = 0; i < 2; ++i) {
    rates -= solution.leastNorm((toolDisplacement(J, period * rates) - wanted) / period);
  }
  return rates;
}

JointVector RedundancyResolution::rates(const ResolutionChoice& choice, const JointVector& q, const Jacobian& J,
                                        const Vector6& twist, double period) const noexcept {
  const Prepared& chosen = prepared(choice);
  JointVector rates;
  if (choice.solution == Solution::partitioned && isPartitionable_) {
    rates = compose(PartitionedSolution(q, J, squaredWeights_, control_), choice.strategy, chosen, J, twist, period);
  } else {
    rates = compose(FullSolution(J, squaredWeights_, control_), choice.strategy, chosen, J, twist, period);
  }
  return rates.allFinite() ? rates : JointVector::Zero();
}

}  // namespace haptiv
