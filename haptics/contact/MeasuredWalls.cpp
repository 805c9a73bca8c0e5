#include "haptics/contact/MeasuredWalls.h"

#include "haptics/shapes/StraightBoxSurface.h"

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

}  // namespace

void MeasuredWalls::measure(std::size_t wall) noexcept {
  const Shape& shape = scene_.walls[wall].shape;
  if (shape.kind == Shape::Kind::mesh) return;
  const SurfacePoint point = nearestSurface(shape, place_);
  if (point.distance < reach_) takeNear(near_, wall, point);
}

void MeasuredWalls::measureAll() noexcept {
  for (std::size_t i = 0; i < scene_.walls.size(); ++i) measure(i);
}

void MeasuredWalls::measure(const ShapeIndex::Entry& entry) noexcept {
  if (!entry.isStraight) return measure(std::size_t{entry.shape});
  const SurfacePoint point = nearestOnStraightBox(entry.box, BesideBox(entry.box, place_));
  if (point.distance < reach_) takeNear(near_, entry.shape, point);
}

void MeasuredWalls::measureEach(const ShapeIndex::Entry& a, const ShapeIndex::Entry& b) noexcept {
  measure(a);
  if (&a != &b) measure(b);
}

}  // namespace haptiv
