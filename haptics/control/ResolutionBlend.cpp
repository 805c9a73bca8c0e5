#include "haptics/control/ResolutionBlend.h"

#include <algorithm>

namespace haptiv {

JointVector ResolutionBlend::rates(const RedundancyResolution& resolution, const ResolutionChoice& wanted,
                                   const JointVector& q, const Jacobian& J, const Vector6& twist,
                                   double period) noexcept {
  if (share >= 1 && !(wanted == to)) {
    from = to;
    to = wanted;
    share = 0;
  }
  share = std::min(1., share + period / kDuration);
  const JointVector next = resolution.rates(to, q, J, twist, period);
  if (share >= 1) return next;
  return share * next + (1 - share) * resolution.rates(from, q, J, twist, period);
}

}  // namespace haptiv
