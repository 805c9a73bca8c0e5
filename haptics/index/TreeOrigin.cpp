#include "haptics/index/TreeOrigin.h"

#include <cmath>
#include <limits>

namespace haptiv {
namespace {

bool isFinite(const Bounds& box) noexcept {
  return box.low.allFinite() && box.high.allFinite();
}

}  // namespace

BoundsOfAll::BoundsOfAll() noexcept {
  constexpr double kEnd = std::numeric_limits<double>::max() / 2;
  all_ = {Vector3::Constant(kEnd), Vector3::Constant(-kEnd)};
}

BoundsOfAll::BoundsOfAll(std::span<const Bounds> boxes) noexcept : BoundsOfAll() {
  for (const Bounds& box : boxes) add(box);
}

void BoundsOfAll::add(const Bounds& box) noexcept {
  if (!isFinite(box)) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    if (box.low[k] <= all_.low[k]) count_.low[i] = box.low[k] < all_.low[k] ? 1 : count_.low[i] + 1;
    if (box.high[k] >= all_.high[k]) count_.high[i] = box.high[k] > all_.high[k] ? 1 : count_.high[i] + 1;
  }
  all_.low = all_.low.cwiseMin(box.low);
  all_.high = all_.high.cwiseMax(box.high);
}

bool BoundsOfAll::remove(const Bounds& box) noexcept {
  if (!isFinite(box)) return true;
  bool isKnown = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    if (box.low[k] <= all_.low[k] && --count_.low[i] == 0) isKnown = false;
    if (box.high[k] >= all_.high[k] && --count_.high[i] == 0) isKnown = false;
  }
  return isKnown;
}

Vector3 originOf(const Bounds& all) noexcept {
  constexpr double kCells = 8;  // of the grid, at least, to the largest extent
  const double extent = (0.5 * all.high - 0.5 * all.low).maxCoeff();
  const double cell = std::exp2(std::floor(std::log2(2 * extent / kCells)));
  Vector3 origin = 0.5 * all.low + 0.5 * all.high;
  if (cell > 0 && std::isfinite(cell)) origin = cell * (origin / cell).array().round();
  return origin.allFinite() ? origin : Vector3(Vector3::Zero());
}

}  // namespace haptiv
