#pragma once

#include <array>

#include "device/types.h"
#include "haptics/geometry/Pair.h"

namespace haptiv {

/// Where the corners of a triangle are.
using CornerPointers = std::array<const Vector3*, 3>;
using TwoTriangles = std::array<CornerPointers, 2>;

/// How a place lies to two triangles.
struct TwoDistances {
  std::array<Pair, 3> away;  ///< by axis, from the nearest point of the triangle to the place [m]
  Pair squared;              ///< of the distance [m^2]

  Vector3 awayOf(int i) const noexcept { return {away[0][i], away[1][i], away[2][i]}; }
};

/// closestOnTriangle of two triangles in the time of one: no jumps, which would depend on where the place happens to
/// lie and could not be foreseen. The same up to rounding. Realtime-safe: yes.
void measureTwo(const Vector3& p, const TwoTriangles& triangles, TwoDistances& distances) noexcept;

}  // namespace haptiv
