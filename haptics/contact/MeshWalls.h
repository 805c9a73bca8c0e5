#pragma once

#include <cstdint>

#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// Calls visit(wall) for the mesh walls that `find(tree, visitItem)` finds in the scene's tree of them; where there is
/// none, for all.
template <typename Find, typename Visit>
void forEachMeshWall(const HapticScene& scene, Find&& find, Visit&& visit) noexcept {
  if (scene.wallIndex.tree.size() == scene.walls.size()) {
    find(scene.meshIndex.tree, [&](std::size_t i) { visit(scene.meshIndex.wall[i]); });
    return;
  }
  for (std::size_t i = 0; i < scene.walls.size(); ++i) {
    if (scene.walls[i].shape.kind == Shape::Kind::mesh && scene.walls[i].shape.mesh)
      visit(static_cast<std::uint32_t>(i));
  }
}

/// Those that may be no farther from p_W than `reach` [m].
template <typename Visit>
void forEachMeshWallWithin(const HapticScene& scene, const Vector3& p_W, double reach, Visit&& visit) noexcept {
  forEachMeshWall(
      scene, [&](const BoundingTree& tree, auto&& found) { tree.forEachWithin(p_W, reach, found); }, visit);
}

}  // namespace haptiv
