#include "haptics/scene/HapticScene.h"

#include <algorithm>
#include <numeric>

#include "haptics/shapes/ShapeDistance.h"
#include "haptics/shapes/StraightBoxSurface.h"

namespace haptiv {
namespace {

ShapeIndex::Entry entryOf(const Shape& shape, std::uint32_t number) {
  ShapeIndex::Entry entry;
  entry.shape = number;
  const auto box = shape.kind == Shape::Kind::box ? straightBox(shape) : std::nullopt;
  entry.isStraight = box.has_value();
  if (box) entry.box = *box;
  return entry;
}

template <typename Felt>
ShapeIndex indexOf(const std::vector<Felt>& shapes) {
  std::vector<Bounds> bounds;
  bounds.reserve(shapes.size());
  for (const Felt& each : shapes) bounds.push_back(boundsOf(each.shape));
  ShapeIndex index;
  index.tree = BoundingTree(bounds);
  index.entries.reserve(shapes.size());
  for (const std::uint32_t shape : index.tree.renumber()) index.entries.push_back(entryOf(shapes[shape].shape, shape));
  index.byId.resize(shapes.size());
  std::iota(index.byId.begin(), index.byId.end(), 0U);
  const auto byId = [&](std::uint32_t a, std::uint32_t b) {
    return shapes[a].id != shapes[b].id ? shapes[a].id < shapes[b].id : a < b;
  };
  if (!std::is_sorted(index.byId.begin(), index.byId.end(), byId)) {
    std::sort(index.byId.begin(), index.byId.end(), byId);
  }
  return index;
}

MeshIndex meshesOf(const std::vector<Wall>& walls) {
  MeshIndex index;
  std::vector<Bounds> bounds;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const Shape& shape = walls[i].shape;
    if (shape.kind != Shape::Kind::mesh || !shape.mesh) continue;
    bounds.push_back(boundsOf(shape));
    index.wall.push_back(static_cast<std::uint32_t>(i));
  }
  index.tree = BoundingTree(bounds);
  return index;
}

}  // namespace

void computeBounds(HapticScene& scene) {
  scene.wallIndex = indexOf(scene.walls);
  scene.zoneIndex = indexOf(scene.zones);
  scene.meshIndex = meshesOf(scene.walls);
}

}  // namespace haptiv
