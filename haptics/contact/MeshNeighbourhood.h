#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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

/// The triangles of the scene's mesh walls that the proxy may meet within a tick. Lives for that tick.
///
/// What is near the proxy's way is found once and kept; where that is not enough (a long way, very many triangles), the
/// trees are asked each time: slower, and the same. Of a kept triangle it is known from where it was measured last how
/// near it can be elsewhere: its distance is convex, so it is nowhere nearer than along the normal of that place. Most
/// need not be measured again. Realtime-safe: yes.
class MeshNeighbourhood {
 public:
  /// @param proxy  where the proxy is, p_WT [m]
  /// @param step   that its goal has moved since the tick before [m]
  /// @param goal   [m]
  MeshNeighbourhood(const HapticScene& scene, const Vector3& proxy, const Vector3& step, const Vector3& goal,
                    double radius) noexcept
      : scene_(scene) {
    if (scene.meshIndex.tree.size() == 0 && scene.wallIndex.tree.size() == scene.walls.size()) return;
    findAround(proxy, step, (goal - proxy).norm(), radius);
  }

  /// Whether no mesh is as near as the proxy can feel.
  bool isEmpty() const noexcept { return isEmpty_; }

  /// How far along a straight way everything that a ball may touch is known without asking the trees; 0 where it is not
  /// even at the start [m].
  double knownAlong(const Vector3& from_W, const Vector3& direction, double radius) const noexcept {
    const Vector3 d = from_W - centre_;
    const double room = reach_ - radius, along = d.dot(direction);
    if (!isKept_ || !(room > d.norm())) return 0;
    return std::sqrt(along * along + room * room - d.squaredNorm()) - along;
  }

  /// Calls visit(wall, triangle, closest) for the triangles that are no farther from p_W than `reach`; `closest` is
  /// the triangle's point nearest to p_W.
  template <typename Visit>
  void forEachNear(const Vector3& p_W, double reach, Visit&& visit) noexcept;

  /// Calls visit(wall, triangle, closest) for the nearest triangle, where it is kept and no farther than `reach`.
  template <typename Visit>
  void nearest(const Vector3& p_W, double reach, Visit&& visit) noexcept;

  /// Calls visit(start, closest) for the triangles that a ball may touch on its straight way before it has gone `free`,
  /// which the visitor may shorten: before `start` it does not touch this one, and closest(p_W) is the triangle's point
  /// nearest to a place. The one that seems to be met first comes first; those out of the way do not come at all.
  template <typename Visit>
  void forEachAlong(const Vector3& from_W, const Vector3& direction, double radius, const OutOfTheWay& out,
                    const double& free, Visit&& visit) noexcept;

 private:
  static constexpr std::size_t kMost = 192;

  void findAround(const Vector3& proxy, const Vector3& step, double farthest, double radius) noexcept;
  /// @param likely   within this distance of centre_ the proxy will probably stay and feel [m]
  /// @param certain  within this one it will in any case [m]
  void find(double likely, double certain) noexcept;
  /// Of the first `found` triangles, whose boxes are near centre_, keeps those that are no farther than `reach`.
  void keepNear(std::size_t found, double reach) noexcept;
  /// The found triangles from one on; where there are only one, it twice.
  TwoTriangles twoFrom(std::size_t first, std::size_t found) const noexcept;
  /// Keeps the i-th triangle found, one of two, if the square of its distance is `most` at most [m^2].
  void keep(std::size_t i, const TwoDistances& two, std::size_t lane, double most) noexcept;

  Vector3 closest(std::uint32_t wall, std::uint32_t triangle, const Vector3& p_W) const noexcept {
    const TriangleMesh& mesh = *scene_.walls[wall].shape.mesh;
    return closestOnTriangle(p_W, mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2));
  }

  bool isOut(std::uint32_t wall, std::uint32_t triangle, const OutOfTheWay& out) const noexcept {
    const TriangleMesh& mesh = *scene_.walls[wall].shape.mesh;
    const auto height = [&](std::size_t corner) { return out.normal.dot(mesh.corner(triangle, corner)); };
    return std::max({height(0), height(1), height(2)}) <= out.offset;
  }

  /// The kept triangle's point nearest to p_W; and from now on its bound is the one from there.
  Vector3 measure(std::size_t i, const Vector3& p_W) noexcept {
    const Vector3 at = closest(wall_[i], triangle_[i], p_W);
    bound(i, p_W, at);
    return at;
  }
  void bound(std::size_t i, const Vector3& p_W, const Vector3& at) noexcept {
    const Vector3 away = p_W - at;
    const double distance = away.norm();
    const Vector3 normal = distance > 0 ? Vector3(away / distance) : Vector3::Zero();
    for (std::size_t axis = 0; axis < 3; ++axis) normal_[axis][i] = normal[static_cast<Eigen::Index>(axis)];
    offset_[i] = distance - normal.dot(p_W - centre_) - roundingAt(p_W);
  }
  static double roundingAt(const Vector3& p_W) noexcept { return 4e-15 * p_W.cwiseAbs().maxCoeff(); }

  /// No kept triangle is nearer to p_W than this, each.
  void boundDistances(const Vector3& p_W, std::array<double, kMost>& least) const noexcept {
    const Vector3 p = p_W - centre_;
    for (std::size_t i = 0; i < count_; ++i) {
      least[i] = offset_[i] + normal_[0][i] * p.x() + normal_[1][i] * p.y() + normal_[2][i] * p.z();
    }
  }

  /// Calls visit(wall) for the mesh walls that `find(tree, visitItem)` finds in the scene's tree.
  template <typename Find, typename Visit>
  static void searchWalls(const HapticScene& scene, Find&& find, Visit&& visit) noexcept;

  /// Calls visit(wall, triangle) for the triangles that it finds in all trees.
  template <typename Find, typename Visit>
  void search(Find&& find, Visit&& visit) const noexcept;

  /// The first of the smallest, found without jumps that cannot be foreseen; 0 where there is none.
  std::size_t smallest(const std::array<double, kMost>& of) const noexcept {
    double least = of[0];
    for (std::size_t i = 1; i < count_; ++i) least = of[i] < least ? of[i] : least;
    std::size_t at = 0;
    while (at + 1 < count_ && of[at] != least) ++at;
    return at;
  }

  /// Whether all that are within `reach` of p_W are kept.
  bool areKept(const Vector3& p_W, double reach) const noexcept {
    return isKept_ && reach + (p_W - centre_).norm() <= reach_;
  }

  const HapticScene& scene_;
  Vector3 centre_ = Vector3::Zero();
  double reach_ = 0;
  bool isEmpty_ = true;
  bool isKept_ = true;  ///< all within reach_
  std::size_t count_ = 0;
  std::array<std::uint32_t, kMost> wall_, triangle_;
  std::array<std::array<double, kMost>, 3> normal_;  ///< by axis: |x - triangle| >= normal . (x - centre_) + offset ...
  std::array<double, kMost> offset_;                 ///< ... for all places x [m]
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
void MeshNeighbourhood::forEachNear(const Vector3& p_W, double reach, Visit&& visit) noexcept {
  const auto take = [&](std::uint32_t wall, std::uint32_t triangle, const Vector3& at) {
    if ((at - p_W).squaredNorm() <= reach * reach) visit(wall, triangle, at);
  };
  if (!areKept(p_W, reach)) {
    search([&](const BoundingTree& tree, auto&& found) { tree.forEachWithin(p_W, reach, found); },
           [&](std::uint32_t wall, std::uint32_t triangle) { take(wall, triangle, closest(wall, triangle, p_W)); });
    return;
  }
  std::array<double, kMost> least;
  boundDistances(p_W, least);
  for (std::size_t i = 0; i < count_; ++i) {
    if (least[i] <= reach) take(wall_[i], triangle_[i], measure(i, p_W));
  }
}

template <typename Visit>
void MeshNeighbourhood::nearest(const Vector3& p_W, double reach, Visit&& visit) noexcept {
  if (!areKept(p_W, reach) || count_ == 0) return;
  std::array<double, kMost> least;
  boundDistances(p_W, least);
  Vector3 at = Vector3::Zero();
  for (std::size_t last = count_;;) {
    const std::size_t i = smallest(least);
    if (!(least[i] <= reach)) return;
    if (i == last) return visit(wall_[i], triangle_[i], at);
    at = measure(i, p_W);
    least[i] = (p_W - at).norm();
    last = i;
  }
}

template <typename Visit>
void MeshNeighbourhood::forEachAlong(const Vector3& from_W, const Vector3& direction, double radius,
                                     const OutOfTheWay& out, const double& free, Visit&& visit) noexcept {
  const Vector3 to_W = from_W + free * direction;
  if (!areKept(from_W, radius) || !areKept(to_W, radius)) {  // a ball is convex: what is between is within, too
    search([&](const BoundingTree& tree, auto&& found) { tree.forEachAlong(from_W, to_W, radius, found); },
           [&](std::uint32_t wall, std::uint32_t triangle) {
             if (isOut(wall, triangle, out)) return;
             visit(0.0, [&](const Vector3& p) { return closest(wall, triangle, p); });
           });
    return;
  }
  if (count_ == 0) return;
  std::array<double, kMost> start;
  boundDistances(from_W, start);
  for (std::size_t i = 0; i < count_; ++i) {
    const double approach =
        -(normal_[0][i] * direction.x() + normal_[1][i] * direction.y() + normal_[2][i] * direction.z());
    start[i] = std::max(0.0, (start[i] - radius) / std::max(approach, std::numeric_limits<double>::min()));
  }
  const std::size_t first = smallest(start);
  const auto meet = [&](std::size_t i) {
    if (start[i] < free && !isOut(wall_[i], triangle_[i], out))
      visit(start[i], [&](const Vector3& p) { return measure(i, p); });
  };
  meet(first);
  for (std::size_t i = 0; i < count_; ++i) {
    if (i != first) meet(i);
  }
}

}  // namespace haptiv
