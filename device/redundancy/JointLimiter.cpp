#include "device/redundancy/JointLimiter.h"

#include <algorithm>
#include <cmath>

namespace haptiv {

double slowDownFactor(const JointVector& rates, const JointVector& rateLimit) noexcept {
  double factor = 1;
  for (int i = 0; i < kJointCount; ++i) {
    if (std::abs(rates[i]) > rateLimit[i]) factor = std::min(factor, rateLimit[i] / std::abs(rates[i]));
  }
  return factor;
}

}  // namespace haptiv
