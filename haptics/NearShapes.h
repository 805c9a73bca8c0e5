#pragma once

#include <cstddef>
#include <vector>

#include "haptics/ShapeDistance.h"

namespace haptiv {

/// Calls `visit(index, nearestSurface)` for every wall or zone whose surface is nearer to p_W than `reach`, or that
/// has p_W inside. Realtime-safe: yes, where computeBounds was called or not.
template <typename Felt, typename Visit>
void forEachNear(const std::vector<Felt>& shapes, const std::vector<Bounds>& bounds, const Vector3& p_W, double reach,
                 Visit&& visit) noexcept {
  const bool known = bounds.size() == shapes.size();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Bounds box = known ? bounds[i] : boundsOf(shapes[i].shape);
    if (((p_W - box.low).array() < -reach).any() || ((p_W - box.high).array() > reach).any()) continue;
    const SurfacePoint surface = nearestSurface(shapes[i].shape, p_W);
    if (surface.distance < reach) visit(i, surface);
  }
}

}  // namespace haptiv
