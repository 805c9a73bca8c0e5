#include "haptics/contact/WallsAround.h"

#include "haptics/index/Fetch.h"
#include "haptics/scene/NearShapes.h"

namespace haptiv {
namespace {

/// Drops the farthest if `found` is nearer; of equally far ones, the last.
[[gnu::noinline]] bool makeRoom(NearSurfaces& near, const NearSurface& found) noexcept {
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
[[gnu::always_inline]] inline void takeNear(NearSurfaces& near, const NearSurface& found) noexcept {
  if (near.count == NearSurfaces::kMost && !makeRoom(near, found)) return;
  std::size_t at = near.count++;
  for (; at > 0 && near.surface[at - 1].wall > found.wall; --at) near.surface[at] = near.surface[at - 1];
  near.surface[at] = found;
}

}  // namespace

void findWallsAround(const HapticScene& scene, const Vector3& place, double reach, RememberedBoxes& boxes,
                     const RememberedBoxes::Ahead& ahead, NearSurfaces& near) noexcept {
  near.count = 0;
  const auto remembered = [&](std::uint32_t item) { fetch(scene.wallIndex.entries[item]); };
  const auto search = [&](const BoundingTree& tree, auto&& found) {
    boxes.forEachNear(tree, place, reach, ahead, found, remembered);
  };
  const auto isExact = [](const Shape& shape) { return shape.kind != Shape::Kind::mesh; };
  measureNear(scene.walls, scene.wallIndex, place, reach, search, isExact,
              [&](std::size_t wall, const SurfacePoint& surface) {
                fetch(scene.walls[wall].id);  // it may soon be touched
                fetch(scene.walls[wall].surface);
                takeNear(near, {static_cast<std::int32_t>(wall), surface.face, surface.distance, surface.normal});
              });
}

}  // namespace haptiv
