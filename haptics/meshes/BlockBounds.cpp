#include "haptics/meshes/BlockBounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace haptiv {
namespace {

/// dot = u . v
void dot(const Quad3& u, const Quad3& v, Quad& dot) noexcept {
  dot = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

void inverseRoot(const Quad& squared, Quad& inverse) noexcept {
#ifdef __SSE2__
  inverse = 1 / _mm_sqrt_ps(squared);
#else
  for (int i = 0; i < 4; ++i) inverse[i] = 1 / std::sqrt(squared[i]);
#endif
}

/// Triangles from their first corners: to the place, and to the other corners.
struct Sides {
  Quad3 ap, ab, ac;
};

/// A point of each triangle: a + (b / sum) ab + (c / sum) ac.
struct QuadWeights {
  Quad b, c, sum;
};

/// Where `is` holds, x; else zero.
template <typename Mask>
Mask where(const Mask& is, const Quad& x) noexcept {
  return is & reinterpret_cast<Mask>(x);
}

/// The regions of closestOnTriangle; where two meet, both name the same point.
void findNearest(const Sides& side, QuadWeights& nearest) noexcept {
  Quad d1, d2, abab, abac, acac;
  dot(side.ab, side.ap, d1);
  dot(side.ac, side.ap, d2);
  dot(side.ab, side.ab, abab);
  dot(side.ab, side.ac, abac);
  dot(side.ac, side.ac, acac);
  const Quad d3 = d1 - abab, d4 = d2 - abac, d5 = d1 - abac, d6 = d2 - acac, fromB = d4 - d3, fromC = d5 - d6;
  const Quad towardsA = d3 * d6 - d5 * d4, towardsB = d5 * d2 - d1 * d6, towardsC = d1 * d4 - d3 * d2;
  const auto isA = (d1 <= 0) & (d2 <= 0), isB = (d3 >= 0) & (d4 <= d3), isC = (d6 >= 0) & (d5 <= d6);
  const auto isAB = (towardsC <= 0) & (d1 >= 0) & (d3 <= 0), isAC = (towardsB <= 0) & (d2 >= 0) & (d6 <= 0);
  const auto isBC = (towardsA <= 0) & (fromB >= 0) & (fromC >= 0);
  const auto isFace = ~(isA | isB | isC | isAB | isAC | isBC);
  const Quad one = Quad{} + 1, face = towardsA + towardsB + towardsC;
  const auto b = where(isB, one) | where(isAB, d1) | where(isBC, fromC) | where(isFace, towardsB);
  const auto c = where(isC, one) | where(isAC, d2) | where(isBC, fromB) | where(isFace, towardsC);
  const auto sum = where(isA | isB | isC, one) | where(isAB, abab) | where(isAC, acac) | where(isBC, fromB + fromC) |
                   where(isFace, face);
  nearest = {reinterpret_cast<Quad>(b), reinterpret_cast<Quad>(c), reinterpret_cast<Quad>(sum)};
}

}  // namespace

void boundBlock(const TriangleBlock& block, const Vector3& p_W, BlockBounds& bounds) noexcept {
  constexpr double kRounding = 1e-6, kMost = 1e9;
  const Vector3 p = p_W - block.origin;
  const double numbers = p.cwiseAbs().sum() + double{block.size};
  const float rounding =
      numbers < kMost ? static_cast<float>(kRounding * numbers) : std::numeric_limits<float>::infinity();
  const auto& [a, b, c] = block.corner;
  Sides side;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    side.ap[axis] = static_cast<float>(std::clamp(p[static_cast<Eigen::Index>(axis)], -kMost, kMost)) - a[axis];
    side.ab[axis] = b[axis] - a[axis];
    side.ac[axis] = c[axis] - a[axis];
  }
  QuadWeights nearest;
  findNearest(side, nearest);
  const Quad scale = 1 / nearest.sum, partB = nearest.b * scale, partC = nearest.c * scale;
  Quad3 away;
  for (std::size_t axis = 0; axis < 3; ++axis)
    away[axis] = side.ap[axis] - (side.ab[axis] * partB + side.ac[axis] * partC);
  Quad squared, inverse, toA, fromAToB, fromAToC;
  dot(away, away, squared);
  inverseRoot(squared, inverse);
  dot(away, side.ap, toA);
  dot(away, side.ab, fromAToB);
  dot(away, side.ac, fromAToC);
  const Quad highest = fromAToB > fromAToC ? fromAToB : fromAToC;
  const Quad lowest = toA - (highest > 0 ? highest : Quad{});
  const auto isSound = (squared >= std::numeric_limits<float>::min()) & (squared <= std::numeric_limits<float>::max());
  for (std::size_t axis = 0; axis < 3; ++axis) bounds.normal[axis] = isSound ? away[axis] * inverse : Quad{};
  bounds.distance = isSound ? lowest * inverse - rounding : Quad{};
}

unsigned BlockBounds::nearWay(const std::array<float, 3>& half, float reach) const noexcept {
  const Quad along = normal[0] * half[0] + normal[1] * half[1] + normal[2] * half[2];
  const auto isNear = distance - (along > 0 ? along : -along) <= Quad{} + reach;
#ifdef __SSE2__
  return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(isNear)));
#else
  unsigned bits = 0;
  for (unsigned i = 0; i < 4; ++i) bits |= static_cast<unsigned>(isNear[i] != 0) << i;
  return bits;
#endif
}

}  // namespace haptiv
