#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// The nodes of the meshes' trees that have blocks of triangles within a ball around a place. They are found a few at a
/// time, so that the walk down the trees spreads over many ticks; and on the way the blocks are brought from memory.
/// Numbers, not copies: it is small, and right for one version of a scene. Realtime-safe: yes.
class GatheredBlocks {
 public:
  static constexpr std::size_t kMost = 64;      ///< nodes; where they are more, none
  static constexpr std::size_t kMostWalls = 4;  ///< likewise

  /// Begins with what is no farther from p_W than `reach` [m].
  void start(const HapticScene& scene, const Vector3& p_W, double reach) noexcept;
  /// Looks at so many more nodes.
  void goOn(const HapticScene& scene, std::size_t nodes) noexcept;

  bool isComplete() const noexcept { return wall_ == walls_; }
  /// There was room for all of them.
  bool fits() const noexcept { return fits_; }
  /// How many nodes were looked at.
  std::size_t looks() const noexcept { return looks_; }
  /// Whether what is within `reach` of p_W is within its own ball.
  bool holds(const Vector3& p_W, double reach) const noexcept {
    const double room = reach_ - reach;
    return room > 0 && (p_W - centre_).squaredNorm() < room * room;
  }

  /// Calls visit(wall, blocks) for each wall, with the blocks that BoundingTree::listWithin lists of its tree, in the
  /// same order; false where there is no room for them in `blocks`.
  template <typename Visit>
  bool forEachWall(const HapticScene& scene, const Bounds& around, double reach, std::span<std::uint32_t> blocks,
                   Visit&& visit) const noexcept {
    for (std::uint32_t wall = 0, from = 0; wall < walls_; from = end_[wall++]) {
      const BoundingTree& tree = scene.walls[wallNumber_[wall]].shape.mesh->tree;
      const auto nodes = std::span(node_).subspan(from, end_[wall] - from);
      const std::optional<std::size_t> count = tree.listOf(nodes, around, reach, blocks);
      if (!count || !visit(wallNumber_[wall], blocks.first(*count))) return false;
    }
    return true;
  }

 private:
  void beginWall() noexcept;
  void look(const TriangleMesh& mesh) noexcept;
  void giveUp() noexcept;

  Vector3 centre_ = Vector3::Zero();
  double reach_ = 0;                         ///< [m]
  std::array<std::uint32_t, kMost> node_{};  ///< those with blocks, wall by wall; then those to be looked at
  std::array<std::uint32_t, kMostWalls> wallNumber_{}, end_{};  ///< where each wall's nodes end
  std::uint32_t walls_ = 0, wall_ = 0;                          ///< all, and those that are done
  std::uint32_t kept_ = 0, next_ = 0, known_ = 0;               ///< parts of node_
  std::uint32_t looks_ = 0;
  bool fits_ = true;
};

}  // namespace haptiv
