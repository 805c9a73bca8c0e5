#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "haptics/meshes/TrianglePoint.h"
#include "haptics/meshes/TwoTriangles.h"
#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// Where normal . x <= offset: what is wholly in there is out of the way. A normal of zero and -infinity: nothing is.
struct OutOfTheWay {
  Vector3 normal = Vector3::Zero();
  double offset = -std::numeric_limits<double>::infinity();  ///< [m]
};

/// A triangle of one of a scene's mesh walls.
struct MeshTriangle {
  std::uint32_t wall;
  std::uint32_t number;  ///< within the mesh

  const Vector3& corner(const HapticScene& scene, std::size_t i) const noexcept {
    return scene.walls[wall].shape.mesh->corner(number, i);
  }
  CornerPointers corners(const HapticScene& scene) const noexcept {
    return {&corner(scene, 0), &corner(scene, 1), &corner(scene, 2)};
  }
  /// From its nearest point to p_W.
  Vector3 away(const HapticScene& scene, const Vector3& p_W) const noexcept {
    return p_W - closestOnTriangle(p_W, corner(scene, 0), corner(scene, 1), corner(scene, 2));
  }
  bool isOut(const HapticScene& scene, const OutOfTheWay& out) const noexcept {
    const auto height = [&](std::size_t i) { return out.normal.dot(corner(scene, i)); };
    return std::max({height(0), height(1), height(2)}) <= out.offset;
  }
};

}  // namespace haptiv
