#include "haptics/HapticScene.h"

#include "haptics/ShapeDistance.h"

namespace haptiv {
namespace {

template <typename Felt>
BoundingTree treeOf(const std::vector<Felt>& shapes) {
  std::vector<Bounds> bounds;
  bounds.reserve(shapes.size());
  for (const Felt& each : shapes) bounds.push_back(boundsOf(each.shape));
  return BoundingTree(bounds);
}

}  // namespace

void computeBounds(HapticScene& scene) {
  scene.wallTree = treeOf(scene.walls);
  scene.zoneTree = treeOf(scene.zones);
}

}  // namespace haptiv
