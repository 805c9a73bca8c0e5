#pragma once

#include <array>

#include "haptics/geometry/Pair.h"
#include "haptics/shapes/StraightBox.h"

namespace haptiv {

/// The surfaces of two boxes, as a place sees them.
struct TwoSurfaces {
  PairMask isOutside;          ///< what follows holds only there
  Pair distance;               ///< [m]
  std::array<Pair, 3> normal;  ///< unit, outward, by axis of W
  PairMask face;               ///< as nearestOnBox numbers them
};

/// nearestOnStraightBox of two boxes in the time of one, for a place outside of them: without jumps, which would depend
/// on where it happens to lie. The same to the last bit. Realtime-safe: yes.
/// @tparam Upright  both are isUpright: there is nothing to turn
template <bool Upright = false>
[[gnu::always_inline]] inline TwoSurfaces measureTwo(const Vector3& p_W, const StraightBox& a,
                                                     const StraightBox& b) noexcept {
  std::array<Pair, 3> offset, along, gap, beyond;
  std::array<std::array<Pair, 3>, 3> row;
  for (Eigen::Index k = 0; k < 3; ++k) offset[k] = twice(p_W[k]) - Pair{a.centre[k], b.centre[k]};
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) row[i][k] = Pair{a.normals(i, k), b.normals(i, k)};
    along[i] = Upright ? offset[i] : row[i][0] * offset[0] + row[i][1] * offset[1] + row[i][2] * offset[2];
    gap[i] = absolute(along[i]) - Pair{a.half[i], b.half[i]};
    beyond[i] = withSign(larger(gap[i], Pair{}), along[i]);
  }
  TwoSurfaces two;
  const Pair ofTwo = larger(gap[0], gap[1]);
  const PairMask isSecond = gap[1] > gap[0], isThird = gap[2] > ofTwo;
  const PairMask faced = chosen(isThird, bitsOf(along[2]), chosen(isSecond, bitsOf(along[1]), bitsOf(along[0])));
  two.isOutside = larger(ofTwo, gap[2]) > twice(StraightBox::kOutside);
  two.face = (isThird & 4) | (~isThird & isSecond & 2) | isNegative(faced);
  two.distance = squareRoot(beyond[0] * beyond[0] + beyond[1] * beyond[1] + beyond[2] * beyond[2]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Pair away = Upright ? beyond[k] : row[0][k] * beyond[0] + row[1][k] * beyond[1] + row[2][k] * beyond[2];
    two.normal[k] = away / two.distance;
  }
  return two;
}

}  // namespace haptiv
