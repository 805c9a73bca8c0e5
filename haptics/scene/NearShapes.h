#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "haptics/scene/HapticScene.h"
#include "haptics/shapes/ShapeDistance.h"
#include "haptics/shapes/StraightBoxSurface.h"

namespace haptiv {

/// Calls `visit(index, nearestSurface)` for a wall or zone if its surface is nearer to p_W than `reach`, or if it has
/// p_W inside; where it is no box, only if isMeant(shape). Realtime-safe: yes.
template <typename Felt, typename IsMeant, typename Visit>
void measureShape(const std::vector<Felt>& shapes, std::size_t shape, const Vector3& p_W, double reach,
                  IsMeant&& isMeant, Visit&& visit) noexcept {
  if (shapes[shape].shape.kind != Shape::Kind::box && !isMeant(shapes[shape].shape)) return;
  const SurfacePoint surface = nearestSurface(shapes[shape].shape, p_W);
  if (surface.distance < reach) visit(shape, surface);
}

/// The same of an entry of their index.
template <typename Felt, typename IsMeant, typename Visit>
void measureEntry(const std::vector<Felt>& shapes, const ShapeIndex::Entry& entry, const Vector3& p_W, double reach,
                  IsMeant&& isMeant, Visit&& visit) noexcept {
  if (!entry.isStraight) return measureShape(shapes, entry.shape, p_W, reach, isMeant, visit);
  const BesideBox point(entry.box, p_W);
  if (!(point.gap.maxCoeff() < reach)) return;
  const SurfacePoint surface = nearestOnStraightBox(entry.box, point);
  if (surface.distance < reach) visit(std::size_t{entry.shape}, surface);
}

/// The same of all of them. In no particular order, though always in the same one. Realtime-safe: yes, where
/// computeBounds was called or not.
template <typename Felt, typename IsMeant, typename Visit>
void forEachNear(const std::vector<Felt>& shapes, const ShapeIndex& index, const Vector3& p_W, double reach,
                 IsMeant&& isMeant, Visit&& visit) noexcept {
  if (index.tree.size() != shapes.size()) {
    for (std::size_t i = 0; i < shapes.size(); ++i) measureShape(shapes, i, p_W, reach, isMeant, visit);
    return;
  }
  index.tree.forEachNear(
      p_W, reach, [&](std::uint32_t item) { measureEntry(shapes, index.entries[item], p_W, reach, isMeant, visit); });
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
