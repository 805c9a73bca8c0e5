#include "haptics/planes/PlaneShares.h"

namespace haptiv {

PlaneShares::Settled PlaneShares::shareOneAfterTheOther(const GivingPlanes::Settled& guess) noexcept {
  std::array<double, 32> asked;
  GivingPlanes planes{normal_, missing_, share_, kGive};
  const GivingPlanes::Settled first = planes.settle(guess);
  for (std::size_t i = 0; i < missing_.size(); ++i) asked[i] = missing_[i] + kGive * share_[i];
  planes.missing = {asked.data(), missing_.size()};
  const GivingPlanes::Settled second = planes.settle(first);
  double squares = 0;
  for (const double share : share_) squares += share * share;
  const double longer = stretchOf(squares, second.way.squaredNorm());
  for (double& share : share_) share *= longer;
  return {second.pushing, true, false, longer * second.way};
}

}  // namespace haptiv
