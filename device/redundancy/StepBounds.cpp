#include "device/redundancy/StepBounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace haptiv {

StepBounds stepBounds(const JointVector& leastNorm, const JointVector& selfMotion,
                      const JointVector& rateLimit) noexcept {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  StepBounds bounds{-kInfinity, kInfinity};
  for (int i = 0; i < kJointCount; ++i) {
    if (selfMotion[i] == 0) continue;  // no step changes this joint
    const double perRate = 1 / selfMotion[i];
    const double middle = -leastNorm[i] * perRate;
    const double reach = rateLimit[i] * std::abs(perRate);
    bounds.low = std::max(bounds.low, middle - reach);
    bounds.high = std::min(bounds.high, middle + reach);
  }
  return bounds;
}

double boundedStep(double wanted, const StepBounds& bounds) noexcept {
  const double step = std::min(wanted, bounds.high);
  return step >= std::max(bounds.low, 0.) ? step : 0;
}

}  // namespace haptiv
