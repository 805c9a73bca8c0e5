#include "haptics/contact/MeasuredWalls.h"

#include "haptics/scene/NearShapes.h"

namespace haptiv {
namespace {

/// Drops the farthest if `found` is nearer; of equally far ones, the last.
bool makeRoom(NearSurfaces& near, const NearSurface& found) noexcept {
  std::size_t farthest = 0;
  for (std::size_t i = 1; i < near.count; ++i) {
    if (near.surface[i].distance >= near.surface[farthest].distance) farthest = i;
  }
  const NearSurface& last = near.surface[farthest];
  if (found.distance > last.distance || (found.distance == last.distance && found.wall > last.wall)) return false;
  --near.count;
  for (std::size_t i = farthest; i < near.count; ++i) near.surface[i] = near.surface[i + 1];
  return true;
}

/// The same ones in whatever order they are found.
void takeNear(NearSurfaces& near, std::size_t wall, const SurfacePoint& point) noexcept {
  const NearSurface found{static_cast<std::int32_t>(wall), point.face, point.distance, point.normal};
  if (near.count == NearSurfaces::kMost && !makeRoom(near, found)) return;
  std::size_t at = near.count++;
  for (; at > 0 && near.surface[at - 1].wall > found.wall; --at) near.surface[at] = near.surface[at - 1];
  near.surface[at] = found;
}

auto takeInto(NearSurfaces& near) noexcept {
  return [&near](std::size_t wall, const SurfacePoint& point) { takeNear(near, wall, point); };
}

bool isNoMesh(const Shape& shape) noexcept {
  return shape.kind != Shape::Kind::mesh;
}

}  // namespace

void MeasuredWalls::search() noexcept {
  forEachNear(scene_.walls, scene_.wallIndex, place_, reach_, isNoMesh, takeInto(near_));
}

void MeasuredWalls::measure(const ShapeIndex::Entry& entry) noexcept {
  measureEntry(scene_.walls, entry, place_, reach_, isNoMesh, takeInto(near_));
}

void MeasuredWalls::measureEach(const ShapeIndex::Entry& a, const ShapeIndex::Entry& b) noexcept {
  measure(a);
  if (&a != &b) measure(b);
}

}  // namespace haptiv
