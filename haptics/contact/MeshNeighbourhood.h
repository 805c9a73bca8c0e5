#pragma once

#include "haptics/contact/KeptTriangles.h"
#include "haptics/contact/MeshWalls.h"
#include "haptics/contact/ProxyWay.h"
#include "haptics/contact/RememberedBlocks.h"

namespace haptiv {

/// The triangles of the scene's mesh walls that the proxy may meet within a tick. Lives for that tick.
///
/// What is near the proxy's way is found once and kept. Where that is not enough, what is near enough to be reached in
/// any direction is; and where that is not (a long way, very many triangles), the trees are asked each time: slower,
/// and the same.
class MeshNeighbourhood {
 public:
  /// @param proxy  where the proxy is, p_WT [m]
  /// @param step   that its goal has moved since the tick before [m]
  /// @param goal   [m]
  /// @param blocks  of the scene's meshes, from the ticks before; they change nothing but the time that it takes
  MeshNeighbourhood(const HapticScene& scene, const Vector3& proxy, const Vector3& step, const Vector3& goal,
                    double radius, RememberedBlocks& blocks) noexcept;

  /// Whether no mesh is as near as the proxy can feel.
  bool isEmpty() const noexcept { return isEmpty_; }

  /// Gathers a little of what the next ticks will ask for; at the end of a tick. One that asked for much itself leaves
  /// it to the next, but not twice in a row.
  void lookAhead() noexcept;

  /// How much of a straight way is known without asking the trees; 0 where not even its start is [m].
  double knownAlong(const Vector3& from_W, const Vector3& direction, double length, double radius) const noexcept {
    if (isKept_ && found_.holds(from_W, radius) && found_.holds(from_W + length * direction, radius)) return length;
    return isKept_ ? std::max(0.0, found_.roomAt(from_W) - radius) : 0;
  }

  /// Calls visit(triangle, away) for the triangles that are no farther from p_W than `reach`; `away` leads from the
  /// triangle's nearest point to p_W.
  template <typename Visit>
  void forEachNear(const Vector3& p_W, double reach, Visit&& visit) noexcept;

  /// Calls visit(triangle, away) for the nearest triangle, where it is kept and no farther than `reach`.
  template <typename Visit>
  void nearest(const Vector3& p_W, double reach, Visit&& visit) noexcept;

  /// Calls visit(start, awayOf) for the triangles that a ball may touch on its straight way before it has gone `free`,
  /// which the visitor may shorten: before `start` it does not touch this one, and awayOf(p_W) leads from the
  /// triangle's nearest point to a place. The one that seems to be met first comes first; those out of the way do not
  /// come at all.
  template <typename Visit>
  void forEachAlong(const Vector3& from_W, const Vector3& direction, double radius, const OutOfTheWay& out,
                    const double& free, Visit&& visit) noexcept;

 private:
  /// Keeps what is within it; isKept_ says whether there was room.
  void find(const ProxyWay& around) noexcept;
  bool searchTrees() noexcept;
  bool keepNear(std::uint32_t wall, std::span<const std::uint32_t> blocks) noexcept;

  /// Whether all that are within `reach` of these places are kept, now or after another search.
  bool areKept(const Vector3& one_W, const Vector3& other_W, double reach) noexcept {
    const auto holds = [&] { return isKept_ && found_.holds(one_W, reach) && found_.holds(other_W, reach); };
    if (holds()) return true;
    if (!isKept_ || isWide_) return false;
    isWide_ = true;
    find(wide_);
    return holds();
  }

  /// Calls visit(triangle) for the triangles of the blocks that it finds in all trees.
  template <typename Find, typename Visit>
  void search(Find&& find, Visit&& visit) const noexcept;

  const HapticScene& scene_;
  RememberedBlocks& blocks_;
  double radius_;           ///< of the ball [m]
  ProxyWay likely_, wide_;  ///< where it probably goes; and where it may go at all
  ProxyWay found_;          ///< what is kept is near this
  int asked_ = 0;           ///< from how many places triangles were measured
  bool isEmpty_ = true, isKept_ = true, isWide_ = false;
  KeptTriangles kept_;
};

template <typename Find, typename Visit>
void MeshNeighbourhood::search(Find&& find, Visit&& visit) const noexcept {
  forEachMeshWall(scene_, find, [&](std::uint32_t wall) {
    const TriangleMesh& mesh = *scene_.walls[wall].shape.mesh;
    find(mesh.tree, [&](std::size_t block) {
      mesh.forEachOf(block, [&](std::size_t triangle) {
        visit(MeshTriangle{wall, static_cast<std::uint32_t>(triangle)});
      });
    });
  });
}

template <typename Visit>
void MeshNeighbourhood::forEachNear(const Vector3& p_W, double reach, Visit&& visit) noexcept {
  ++asked_;
  if (!areKept(p_W, p_W, reach)) {
    search([&](const BoundingTree& tree, auto&& found) { tree.forEachWithin(p_W, reach, found); },
           [&](const MeshTriangle& triangle) {
             const Vector3 away = triangle.away(scene_, p_W);
             if (away.squaredNorm() <= reach * reach) visit(triangle, away);
           });
    return;
  }
  std::array<std::uint8_t, KeptTriangles::kMost> near;
  const std::size_t count = kept_.listNear(p_W, reach, near);
  TwoDistances two;
  for (std::size_t i = 0; i < count; ++i) {
    const int lane = static_cast<int>(i % 2);
    if (lane == 0) kept_.measure(scene_, near[i], near[std::min(i + 1, count - 1)], p_W, two);
    if (two.squared[lane] <= reach * reach) visit(kept_[near[i]], two.awayOf(lane));
  }
}

template <typename Visit>
void MeshNeighbourhood::nearest(const Vector3& p_W, double reach, Visit&& visit) noexcept {
  if (!areKept(p_W, p_W, reach) || kept_.count() == 0) return;
  KeptTriangles::Each least;
  kept_.boundDistances(p_W, least);
  Vector3 away = Vector3::Zero();
  for (std::size_t last = kept_.count();;) {
    const std::size_t i = kept_.smallest(least);
    if (!(least[i] <= reach)) return;
    if (i == last) return visit(kept_[i], away);
    away = kept_.measure(scene_, i, p_W);
    least[i] = away.norm();
    last = i;
  }
}

template <typename Visit>
void MeshNeighbourhood::forEachAlong(const Vector3& from_W, const Vector3& direction, double radius,
                                     const OutOfTheWay& out, const double& free, Visit&& visit) noexcept {
  const Vector3 to_W = from_W + free * direction;
  if (!areKept(from_W, to_W, radius)) {
    search([&](const BoundingTree& tree, auto&& found) { tree.forEachAlong(from_W, to_W, radius, found); },
           [&](const MeshTriangle& triangle) {
             if (triangle.isOut(scene_, out)) return;
             visit(0.0, [&](const Vector3& p) { return triangle.away(scene_, p); });
           });
    return;
  }
  if (kept_.count() == 0) return;
  KeptTriangles::Each start;
  kept_.boundStarts(from_W, direction, radius, start);
  const std::size_t first = kept_.smallest(start);
  const auto meet = [&](std::size_t i) {
    if (start[i] < free && !kept_[i].isOut(scene_, out))
      visit(start[i], [&](const Vector3& p) {
        ++asked_;
        return kept_.measure(scene_, i, p);
      });
  };
  meet(first);
  for (std::size_t i = 0; i < kept_.count(); ++i) {
    if (i != first) meet(i);
  }
}

}  // namespace haptiv
