#pragma once

#include "haptics/meshes/TriangleBlock.h"

namespace haptiv {

/// Half spaces that hold the triangles of a block: |x - triangle| >= normal . (x - p) + distance for all places x.
struct BlockBounds {
  Quad3 normal;
  Quad distance;  ///< [m]

  Vector3 normalOf(int lane) const noexcept { return {normal[0][lane], normal[1][lane], normal[2][lane]}; }

  /// One bit for each triangle that may be nearer than `reach` to the straight way from p - half to p + half.
  unsigned nearWay(const std::array<float, 3>& half, float reach) const noexcept;
};

/// Those towards the triangles as they lie to p_W. The distances fall short of the true ones by what single precision
/// rounds; where a triangle is (almost) a line or a point, or has p_W on it, the normal is zero, and so is the
/// distance.
///
/// The nearest points are found by the regions of closestOnTriangle, all of them each time: no jumps, which would
/// depend on where the place happens to lie and could not be foreseen. They need not be exact: whatever the direction,
/// the nearest of the corners along it bounds all of the triangle. Realtime-safe: yes.
void boundBlock(const TriangleBlock& block, const Vector3& p_W, BlockBounds& bounds) noexcept;

}  // namespace haptiv
