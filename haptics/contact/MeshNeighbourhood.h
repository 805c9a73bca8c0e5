#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "haptics/HapticScene.h"
#include "haptics/meshes/TrianglePoint.h"

namespace haptiv {

/// The triangles of the scene's mesh walls that the proxy may meet within a tick. Lives for that tick.
///
/// What is near the proxy is measured once and kept; where that is not enough (a long way, very many triangles), the
/// trees are asked each time: slower, and the same. Realtime-safe: yes.
class MeshNeighbourhood {
 public:
  /// @param likely   within this distance of p_W the proxy will probably stay and feel [m]
  /// @param certain  within this one it will in any case [m]
  MeshNeighbourhood(const HapticScene& scene, const Vector3& p_W, double likely, double certain) noexcept
      : scene_(scene), centre_(p_W), reach_(likely * (1 - 1e-9)) {
    if (scene.meshIndex.tree.size() > 0 || scene.wallIndex.tree.size() != scene.walls.size()) measure(likely, certain);
  }

  /// Whether no mesh is as near as the proxy can feel.
  bool isEmpty() const noexcept { return isEmpty_; }

  /// How far around p_W everything is known without asking the trees, beyond a ball's radius; 0 where it is not [m].
  double knownAround(const Vector3& p_W, double radius) const noexcept {
    return isKept_ ? std::max(0.0, reach_ - radius - (p_W - centre_).norm()) : 0;
  }

  /// Calls visit(wall, triangle, closest) for the triangles that are no farther from p_W than `reach`; `closest` is
  /// the triangle's point nearest to p_W.
  template <typename Visit>
  void forEachNear(const Vector3& p_W, double reach, Visit&& visit) const noexcept;

  /// Calls visit(wall, triangle) for the triangles that a ball of radius `reach` may touch on the straight way.
  template <typename Visit>
  void forEachAlong(const Vector3& from_W, const Vector3& to_W, double reach, Visit&& visit) const noexcept;

  /// The triangle's point nearest to p_W.
  Vector3 closest(std::uint32_t wall, std::uint32_t triangle, const Vector3& p_W) const noexcept {
    const TriangleMesh& mesh = *scene_.walls[wall].shape.mesh;
    return closestOnTriangle(p_W, mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2));
  }

 private:
  struct Near {
    std::uint32_t wall;
    std::uint32_t triangle;
    double distance;  ///< from centre_ [m]
  };
  static constexpr std::size_t kMost = 96;

  void measure(double likely, double certain) noexcept;

  /// Calls visit(wall) for the mesh walls that `find(tree, visitItem)` finds in the scene's tree.
  template <typename Find, typename Visit>
  static void searchWalls(const HapticScene& scene, Find&& find, Visit&& visit) noexcept;

  /// Calls visit(wall, triangle) for the triangles that it finds in all trees.
  template <typename Find, typename Visit>
  void search(Find&& find, Visit&& visit) const noexcept;

  /// Calls visit(wall, triangle) for kept triangles within `reach` of p_W, and perhaps others; false where not all
  /// that are within reach are kept.
  template <typename Visit>
  bool forEachKept(const Vector3& p_W, double reach, Visit&& visit) const noexcept;

  const HapticScene& scene_;
  Vector3 centre_;
  double reach_;
  bool isEmpty_ = true;
  bool isKept_ = true;  ///< all within reach_
  std::size_t count_ = 0;
  std::array<Near, kMost> near_;
};

template <typename Find, typename Visit>
void MeshNeighbourhood::searchWalls(const HapticScene& scene, Find&& find, Visit&& visit) noexcept {
  if (scene.wallIndex.tree.size() == scene.walls.size()) {
    find(scene.meshIndex.tree, [&](std::size_t i) { visit(scene.meshIndex.wall[i]); });
    return;
  }
  for (std::size_t i = 0; i < scene.walls.size(); ++i) {
    if (scene.walls[i].shape.kind == Shape::Kind::mesh && scene.walls[i].shape.mesh)
      visit(static_cast<std::uint32_t>(i));
  }
}

template <typename Find, typename Visit>
void MeshNeighbourhood::search(Find&& find, Visit&& visit) const noexcept {
  searchWalls(scene_, find, [&](std::uint32_t wall) {
    find(scene_.walls[wall].shape.mesh->tree,
         [&](std::size_t triangle) { visit(wall, static_cast<std::uint32_t>(triangle)); });
  });
}

template <typename Visit>
bool MeshNeighbourhood::forEachKept(const Vector3& p_W, double reach, Visit&& visit) const noexcept {
  const double farthest = reach + (p_W - centre_).norm();
  if (!isKept_ || !(farthest <= reach_)) return false;
  for (std::size_t i = 0; i < count_; ++i) {
    if (near_[i].distance <= farthest) visit(near_[i].wall, near_[i].triangle);
  }
  return true;
}

template <typename Visit>
void MeshNeighbourhood::forEachNear(const Vector3& p_W, double reach, Visit&& visit) const noexcept {
  const auto measure = [&](std::uint32_t wall, std::uint32_t triangle) {
    const Vector3 at = closest(wall, triangle, p_W);
    if ((at - p_W).squaredNorm() <= reach * reach) visit(wall, triangle, at);
  };
  if (forEachKept(p_W, reach, measure)) return;
  search([&](const BoundingTree& tree, auto&& found) { tree.forEachWithin(p_W, reach, found); }, measure);
}

template <typename Visit>
void MeshNeighbourhood::forEachAlong(const Vector3& from_W, const Vector3& to_W, double reach,
                                     Visit&& visit) const noexcept {
  if (forEachKept(from_W, reach + (to_W - from_W).norm(), visit)) return;
  search([&](const BoundingTree& tree, auto&& found) { tree.forEachAlong(from_W, to_W, reach, found); }, visit);
}

}  // namespace haptiv
