#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "haptics/scene/HapticScene.h"
#include "haptics/shapes/ShapeDistance.h"
#include "haptics/shapes/StraightBoxSurface.h"

namespace haptiv {

/// Calls `visit(index, nearestSurface)` for every wall or zone whose surface is nearer to p_W than `reach`, or that
/// has p_W inside; of those that are no boxes, only where isMeant(shape). In no particular order, though always in the
/// same one. Realtime-safe: yes, where computeBounds was called or not.
template <typename Felt, typename IsMeant, typename Visit>
void forEachNear(const std::vector<Felt>& shapes, const ShapeIndex& index, const Vector3& p_W, double reach,
                 IsMeant&& isMeant, Visit&& visit) noexcept {
  const auto measure = [&](std::size_t shape) {
    if (shapes[shape].shape.kind != Shape::Kind::box && !isMeant(shapes[shape].shape)) return;
    const SurfacePoint surface = nearestSurface(shapes[shape].shape, p_W);
    if (surface.distance < reach) visit(shape, surface);
  };
  if (index.tree.size() != shapes.size()) {
    for (std::size_t i = 0; i < shapes.size(); ++i) measure(i);
    return;
  }
  index.tree.forEachNear(p_W, reach, [&](std::uint32_t item) {
    const ShapeIndex::Entry& entry = index.entries[item];
    if (!entry.isStraight) return measure(entry.shape);
    const BesideBox point(entry.box, p_W);
    if (!(point.gap.maxCoeff() < reach)) return;
    const SurfacePoint surface = nearestOnStraightBox(entry.box, point);
    if (surface.distance < reach) visit(std::size_t{entry.shape}, surface);
  });
}

template <typename Felt, typename Visit>
void forEachNear(const std::vector<Felt>& shapes, const ShapeIndex& index, const Vector3& p_W, double reach,
                 Visit&& visit) noexcept {
  forEachNear(
      shapes, index, p_W, reach, [](const Shape&) { return true; }, visit);
}

/// The number of the wall or zone with this id; shapes.size() where there is none. Realtime-safe: yes; it searches
/// through all of them only where computeBounds was forgotten.
template <typename Felt>
std::size_t findShape(const std::vector<Felt>& shapes, const ShapeIndex& index, ShapeId id) noexcept {
  if (index.byId.size() != shapes.size()) {
    const auto found = std::find_if(shapes.begin(), shapes.end(), [&](const Felt& each) { return each.id == id; });
    return static_cast<std::size_t>(found - shapes.begin());
  }
  const auto found = std::lower_bound(index.byId.begin(), index.byId.end(), id,
                                      [&](std::uint32_t shape, ShapeId wanted) { return shapes[shape].id < wanted; });
  return found != index.byId.end() && shapes[*found].id == id ? *found : shapes.size();
}

}  // namespace haptiv
