#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

#include "device/types.h"

namespace haptiv {

/// The point nearest to the origin with normal . y >= offset for all planes, to rounding: on a face, an edge or a
/// corner of what they leave free. Nothing where no point is in all of them, or where planes that it depends on are
/// parallel to within a hundred-thousandth.
///
/// From the origin to the plane that is violated most, from there to the next one: each time the nearest point for up
/// to three old planes and the new one, which is farther away each time (a dual active-set method).
///
/// @param normals  unit
/// Realtime-safe: yes.
[[gnu::noinline]] std::optional<Vector3> nearestCorner(std::span<const Vector3> normals,
                                                       std::span<const double> offsets) noexcept;

inline constexpr double kParallelPlanes = 1e-10;  ///< the square of an angle's sine

/// The same for two planes on both of which it lies; nothing where it does not, or they are parallel.
/// Realtime-safe: yes.
[[gnu::always_inline]] inline std::optional<Vector3> nearestOnEdge(const Vector3& a, double offsetA, const Vector3& b,
                                                                   double offsetB) noexcept {
  const double cosine = a.dot(b);
  const double squaredSine = a.cross(b).squaredNorm();
  const double pushA = offsetA - cosine * offsetB, pushB = offsetB - cosine * offsetA;
  if (!(squaredSine > kParallelPlanes) || !(pushA >= 0) || !(pushB >= 0)) return std::nullopt;
  return (pushA * a + pushB * b) / squaredSine;
}

/// The same for three. Realtime-safe: yes.
[[gnu::always_inline]] inline std::optional<Vector3> nearestInCorner(const Vector3& a, double offsetA, const Vector3& b,
                                                                     double offsetB, const Vector3& c,
                                                                     double offsetC) noexcept {
  const Vector3 bc = b.cross(c), ca = c.cross(a), ab = a.cross(b);
  const double volume = a.dot(bc);
  const double longest = std::max({bc.squaredNorm(), ca.squaredNorm(), ab.squaredNorm()});
  if (!(volume * volume > kParallelPlanes * longest)) return std::nullopt;
  const double inverse = 1 / volume;
  const Vector3 place = (offsetA * bc + offsetB * ca + offsetC * ab) * inverse;
  // It is the sum of the normals, each times what its plane pushes.
  const Vector3 push = Vector3(place.dot(bc), place.dot(ca), place.dot(ab)) * inverse;
  return (push.array() >= 0).all() ? std::optional(place) : std::nullopt;
}

}  // namespace haptiv
