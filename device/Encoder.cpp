#include "device/Encoder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace haptiv {

std::int32_t Encoder::count(double angle) const noexcept {
  using Limits = std::numeric_limits<std::int32_t>;
  return static_cast<std::int32_t>(
      std::clamp<double>(std::round(angle * countsPerRadian_ + zero_), Limits::min(), Limits::max()));
}

}  // namespace haptiv
