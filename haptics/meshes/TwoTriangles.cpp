#include "haptics/meshes/TwoTriangles.h"

#include "haptics/meshes/TrianglePoint.h"

namespace haptiv {
namespace {

using Pair3 = std::array<Pair, 3>;

/// The coordinates of one corner of each.
void gather(const TwoTriangles& triangles, std::size_t corner, Pair3& coordinates) noexcept {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto of = [&](std::size_t i) { return (*triangles[i][corner])[static_cast<Eigen::Index>(axis)]; };
    coordinates[axis] = Pair{of(0), of(1)};
  }
}

void subtract(Pair3& from, const Pair3& what) noexcept {
  for (std::size_t axis = 0; axis < 3; ++axis) from[axis] -= what[axis];
}

/// dot = u . v
void dot(const Pair3& u, const Pair3& v, Pair& dot) noexcept {
  dot = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

/// A point of each triangle: a + (b / sum) ab + (c / sum) ac.
struct Weights {
  Pair b, c, sum;

  /// Where `is` holds, these.
  template <typename Mask>
  void set(const Mask& is, const Pair& newB, const Pair& newC, const Pair& newSum) noexcept {
    b = is ? newB : b;
    c = is ? newC : c;
    sum = is ? newSum : sum;
  }
};

}  // namespace

/// The regions of closestOnTriangle, all of them each time: those that are asked first there, come last.
void measureTwo(const Vector3& p, const TwoTriangles& triangles, TwoDistances& distances) noexcept {
  const Pair none{}, one = none + 1;
  Pair3 a, ab, ac, ap{none + p.x(), none + p.y(), none + p.z()};
  gather(triangles, 0, a);
  gather(triangles, 1, ab);
  gather(triangles, 2, ac);
  subtract(ab, a);
  subtract(ac, a);
  subtract(ap, a);
  Pair d1, d2, abab, abac, acac;
  dot(ab, ap, d1);
  dot(ac, ap, d2);
  dot(ab, ab, abab);
  dot(ab, ac, abac);
  dot(ac, ac, acac);
  const Pair d3 = d1 - abab, d4 = d2 - abac, d5 = d1 - abac, d6 = d2 - acac, fromB = d4 - d3, fromC = d5 - d6;
  const Pair towardsA = d3 * d6 - d5 * d4, towardsB = d5 * d2 - d1 * d6, towardsC = d1 * d4 - d3 * d2;
  Weights at{towardsB, towardsC, towardsA + towardsB + towardsC};
  auto isFound = (towardsA > 0) & (towardsB > 0) & (towardsC > 0) & (at.sum > 0);
  const auto take = [&](const auto& is, const Pair& b, const Pair& c, const Pair& sum) {
    at.set(is, b, c, sum);
    isFound |= is;
  };
  take((towardsA <= 0) & (fromB >= 0) & (fromC >= 0) & (fromB + fromC > 0), fromC, fromB, fromB + fromC);
  take((towardsB <= 0) & (d2 >= 0) & (d6 <= 0) & (acac > 0), none, d2, acac);
  take((towardsC <= 0) & (d1 >= 0) & (d3 <= 0) & (abab > 0), d1, none, abab);
  take((d6 >= 0) & (d5 <= d6), none, one, one);
  take((d3 >= 0) & (d4 <= d3), one, none, one);
  take((d1 <= 0) & (d2 <= 0), none, none, one);
  const Pair b = at.b / at.sum, c = at.c / at.sum;
  for (std::size_t axis = 0; axis < 3; ++axis) distances.away[axis] = ap[axis] - ab[axis] * b - ac[axis] * c;
  if (!(isFound[0] & isFound[1])) {  // lines and points among them
    for (int i = 0; i < 2; ++i) {
      if (isFound[i]) continue;
      const auto& [p0, p1, p2] = triangles[static_cast<std::size_t>(i)];
      const Vector3 away = p - closestOnTriangle(p, *p0, *p1, *p2);
      for (std::size_t axis = 0; axis < 3; ++axis) distances.away[axis][i] = away[static_cast<Eigen::Index>(axis)];
    }
  }
  dot(distances.away, distances.away, distances.squared);
}

}  // namespace haptiv
