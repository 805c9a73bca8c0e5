#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "haptics/geometry/Bounds.h"

namespace haptiv {

/// A box in single precision that is never smaller than the one in double precision it stands for.
/// Its numbers are within +-kFar: what is beyond, is far in any case.
struct FloatBox {
  static constexpr float kFar = 1e37F;  ///< sums and differences of two such numbers do not overflow
  std::array<float, 3> low;
  std::array<float, 3> high;

  /// Holds no box.
  static constexpr FloatBox nowhere() noexcept { return {{1, 1, 1}, {-1, -1, -1}}; }

  bool holds(const FloatBox& other) const noexcept {
    bool does = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      does = does && low[axis] <= other.low[axis] && other.high[axis] <= high[axis];
    }
    return does;
  }

  /// Along a way, and farther by a margin on all sides, to rounding; where that is not a number, no box.
  FloatBox reaching(const Vector3& way, double margin) const noexcept {
    FloatBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double along = way[static_cast<Eigen::Index>(axis)];
      box.low[axis] = limited(low[axis] + std::min(0.0, along) - margin);
      box.high[axis] = limited(high[axis] + std::max(0.0, along) + margin);
    }
    return box;
  }

 private:
  static float limited(double x) noexcept {
    return static_cast<float>(std::min(std::max(-double{kFar}, x), double{kFar}));
  }
};

namespace index_detail {

/// Relative to the size of the numbers: how far double-precision sums of a few terms can be off.
inline constexpr double kDoubleSlack = 1e-12;
/// The same for one rounding to single precision (half an ulp is 6e-8), and what it may be off near zero.
inline constexpr double kFloatSlack = 1.3e-7;
inline constexpr double kSmallest = std::numeric_limits<float>::min();

// The order of min and max decides what becomes of NaN: below, the far low; above, the far high.
inline float roundedDown(double x) noexcept {
  constexpr double far = FloatBox::kFar;
  return static_cast<float>(std::min(std::max(-far, x - kFloatSlack * std::abs(x) - kSmallest), far));
}
inline float roundedUp(double x) noexcept {
  constexpr double far = FloatBox::kFar;
  return static_cast<float>(std::max(std::min(far, x + kFloatSlack * std::abs(x) + kSmallest), -far));
}

}  // namespace index_detail

/// The box from `low` to `high` (in W) as seen from `origin`, a little larger for all rounding on the way. Where a
/// number is not one (NaN), the box reaches as far as boxes do.
inline FloatBox outwards(const Vector3& low, const Vector3& high, const Vector3& origin) noexcept {
  FloatBox box;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double slack = index_detail::kDoubleSlack * (std::abs(low[k]) + std::abs(high[k]) + std::abs(origin[k]));
    box.low[i] = index_detail::roundedDown(low[k] - origin[k] - slack);
    box.high[i] = index_detail::roundedUp(high[k] - origin[k] + slack);
  }
  return box;
}

/// The same for a cube of half edge `reach` about c, already seen from an origin whose numbers are as large as
/// `farOff`. In fewer steps: all of its sides lie farther out by what the largest number may be off.
inline FloatBox cubeAround(const Vector3& c, double reach, double farOff) noexcept {
  const double numbers = std::abs(c.x()) + std::abs(c.y()) + std::abs(c.z()) + std::abs(reach);
  const double half = reach + 2 * index_detail::kFloatSlack * numbers + 4 * index_detail::kDoubleSlack * farOff +
                      index_detail::kSmallest;
  if (!(numbers + half < FloatBox::kFar)) return outwards(c.array() - reach, c.array() + reach, Vector3::Zero());
  FloatBox box;
  for (std::size_t i = 0; i < 3; ++i) {
    const double middle = c[static_cast<Eigen::Index>(i)];
    box.low[i] = static_cast<float>(middle - half);
    box.high[i] = static_cast<float>(middle + half);
  }
  return box;
}

}  // namespace haptiv
