#pragma once

#include <cstddef>
#include <vector>

#include "haptics/ShapeDistance.h"

namespace haptiv {

/// Calls `visit(index, nearestSurface)` for every wall or zone whose surface is nearer to p_W than `reach`, or that
/// has p_W inside. In no particular order, though always in the same one. Realtime-safe: yes, where computeBounds was
/// called or not.
template <typename Felt, typename Visit>
void forEachNear(const std::vector<Felt>& shapes, const BoundingTree& tree, const Vector3& p_W, double reach,
                 Visit&& visit) noexcept {
  const auto measure = [&](std::size_t i) {
    const SurfacePoint surface = nearestSurface(shapes[i].shape, p_W);
    if (surface.distance < reach) visit(i, surface);
  };
  if (tree.size() == shapes.size()) {
    tree.forEachNear(p_W, reach, measure);
  } else {
    for (std::size_t i = 0; i < shapes.size(); ++i) measure(i);
  }
}

}  // namespace haptiv
