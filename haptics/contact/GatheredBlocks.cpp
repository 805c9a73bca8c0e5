#include "haptics/contact/GatheredBlocks.h"

#include <bit>

#include "haptics/contact/MeshWalls.h"
#include "haptics/index/Fetch.h"

namespace haptiv {

void GatheredBlocks::start(const HapticScene& scene, const Vector3& p_W, double reach) noexcept {
  centre_ = p_W;
  reach_ = reach;
  walls_ = wall_ = kept_ = looks_ = 0;
  fits_ = true;
  forEachMeshWallWithin(scene, p_W, reach, [&](std::uint32_t wall) {
    fits_ = fits_ && walls_ < kMostWalls;
    if (fits_) wallNumber_[walls_++] = wall;
  });
  if (!fits_) return giveUp();
  beginWall();
}

void GatheredBlocks::beginWall() noexcept {
  next_ = known_ = kept_;
  if (wall_ == walls_) return;
  if (known_ == kMost) return giveUp();
  node_[known_++] = 0;
}

void GatheredBlocks::giveUp() noexcept {
  fits_ = false;
  walls_ = wall_ = kept_ = 0;
}

void GatheredBlocks::goOn(const HapticScene& scene, std::size_t nodes) noexcept {
  for (; nodes > 0 && wall_ < walls_; --nodes) {
    look(*scene.walls[wallNumber_[wall_]].shape.mesh);
    if (!fits_) return giveUp();
    if (next_ < known_) continue;
    end_[wall_++] = kept_;
    beginWall();
  }
}

/// Level by level. Where a node was looked at, there is room for one that is kept.
void GatheredBlocks::look(const TriangleMesh& mesh) noexcept {
  const std::uint32_t number = node_[next_++];
  const BoxNode& node = mesh.tree.nodes()[number];
  bool hasBlocks = false;
  ++looks_;
  for (unsigned bits = mesh.tree.within(node, centre_, reach_); bits != 0; bits &= bits - 1) {
    const std::uint32_t child = node.child[std::countr_zero(bits)];
    if ((child & BoxNode::kItemFlag) != 0) {
      fetch(mesh.blocks[child & ~BoxNode::kItemFlag]);
      fetch(mesh.triangles[(child & ~BoxNode::kItemFlag) * TriangleBlock::kSize]);
      hasBlocks = true;
    } else if (known_ < kMost) {
      fetch(mesh.tree.nodes()[child]);
      node_[known_++] = child;
    } else {
      fits_ = false;
    }
  }
  if (hasBlocks) node_[kept_++] = number;
}

}  // namespace haptiv
