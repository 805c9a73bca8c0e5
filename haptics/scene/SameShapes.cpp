#include "haptics/scene/SameShapes.h"

#include <algorithm>

namespace haptiv {
namespace {

template <typename Felt>
bool sameShapes(const std::vector<Felt>& some, const std::vector<Felt>& others) {
  return std::ranges::equal(some, others, [](const Felt& a, const Felt& b) {
    return a.id == b.id && a.shape.kind == b.shape.kind && a.shape.centre == b.shape.centre &&
           a.shape.axes == b.shape.axes && a.shape.mesh == b.shape.mesh;
  });
}

}  // namespace

void computeBounds(HapticScene& scene, const HapticScene& before) {
  if (!sameShapes(scene.walls, before.walls) || !sameShapes(scene.zones, before.zones)) return computeBounds(scene);
  scene.wallIndex = before.wallIndex;
  scene.zoneIndex = before.zoneIndex;
  scene.meshIndex = before.meshIndex;
}

}  // namespace haptiv
