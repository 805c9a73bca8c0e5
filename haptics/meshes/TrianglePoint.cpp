#include "haptics/meshes/TrianglePoint.h"

#include <algorithm>

namespace haptiv {
namespace {

Vector3 closestOnEdge(const Vector3& p, const Vector3& a, const Vector3& b) noexcept {
  const Vector3 ab = b - a;
  const double squared = ab.squaredNorm();
  return squared > 0 ? Vector3(a + std::clamp(ab.dot(p - a) / squared, 0.0, 1.0) * ab) : a;
}

/// Slow, and right for triangles that are lines or points, too.
Vector3 closestOnRim(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c) noexcept {
  Vector3 best = closestOnEdge(p, a, b);
  for (const Vector3& other : {closestOnEdge(p, b, c), closestOnEdge(p, c, a)}) {
    if ((other - p).squaredNorm() < (best - p).squaredNorm()) best = other;
  }
  return best;
}

}  // namespace

/// By the regions of corners, edges and face (Ericson, Real-Time Collision Detection, 5.1.5).
Vector3 closestOnTriangle(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c) noexcept {
  const Vector3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const double abab = ab.squaredNorm(), abac = ab.dot(ac), acac = ac.squaredNorm();
  const double d3 = d1 - abab, d4 = d2 - abac;  // the same, from b
  if (d3 >= 0 && d4 <= d3) return b;
  const double d5 = d1 - abac, d6 = d2 - acac;  // and from c
  if (d6 >= 0 && d5 <= d6) return c;
  const double towardsC = d1 * d4 - d3 * d2;  // barycentric coordinates, not yet normalised
  if (towardsC <= 0 && d1 >= 0 && d3 <= 0 && abab > 0) return a + ab * (d1 / abab);
  const double towardsB = d5 * d2 - d1 * d6;
  if (towardsB <= 0 && d2 >= 0 && d6 <= 0 && acac > 0) return a + ac * (d2 / acac);
  const double towardsA = d3 * d6 - d5 * d4;
  const double fromB = d4 - d3, fromC = d5 - d6;
  if (towardsA <= 0 && fromB >= 0 && fromC >= 0 && fromB + fromC > 0) return b + (c - b) * (fromB / (fromB + fromC));
  const double sum = towardsA + towardsB + towardsC;
  if (!(towardsA > 0 && towardsB > 0 && towardsC > 0 && sum > 0)) return closestOnRim(p, a, b, c);
  return a + ab * (towardsB / sum) + ac * (towardsC / sum);
}

}  // namespace haptiv
