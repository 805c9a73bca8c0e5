#pragma once

#include "device/types.h"

namespace haptiv {

/// Step lengths lambda for which no joint exceeds its rate limit, eqs. (19), (20); none where low > high.
struct StepBounds {
  double low;
  double high;
};

/// For qdot = leastNorm + lambda selfMotion with |qdot_i| <= rateLimit_i                [paper, eqs. (16)-(20)]
/// Realtime-safe: yes.
StepBounds stepBounds(const JointVector& leastNorm, const JointVector& selfMotion,
                      const JointVector& rateLimit) noexcept;

/// The step length nearest to the wanted one, which is not negative, within the bounds; never a longer one, never one
/// against the gradient: where the bounds leave nothing, zero.
/// Where least norm is within the limits so are the rates with this step.
double boundedStep(double wanted, const StepBounds& bounds) noexcept;

}  // namespace haptiv
