#include "haptics/index/BoundingTree.h"

#include <stdexcept>
#include <utility>

#include "haptics/index/TreeOrigin.h"

namespace haptiv {

BoundingTree::BoundingTree(std::span<const Bounds> boxes) : BoundingTree(boxes, BoundsOfAll(boxes).bounds()) {}

BoundingTree::BoundingTree(std::span<const Bounds> boxes, const Bounds& all, TreePlan* plan)
    : origin_(originOf(all)), farOff_(origin_.cwiseAbs().sum()), size_(boxes.size()) {
  if (size_ > kMaxItems) throw std::length_error("a bounding tree holds at most 2147483647 boxes");
  std::vector<FloatBox> rounded;
  rounded.reserve(boxes.size());
  for (const Bounds& box : boxes) rounded.push_back(outwards(box.low, box.high, origin_));
  nodes_ = buildNodes(rounded, plan);
}

BoundingTree::BoundingTree(std::vector<BoxNode> nodes, const Vector3& origin, std::size_t size)
    : nodes_(std::move(nodes)), origin_(origin), farOff_(origin_.cwiseAbs().sum()), size_(size) {}

std::optional<std::size_t> BoundingTree::listOf(std::span<const std::uint32_t> nodes, const Bounds& from, double reach,
                                                std::span<std::uint32_t> items) const noexcept {
  return listItemsOf(nodes_, nodes, WithinReach(from, reach, origin_), items);
}

std::vector<std::uint32_t> BoundingTree::renumber() {
  std::vector<std::uint32_t> before;
  before.reserve(size_);
  for (BoxNode& node : nodes_) {
    for (std::uint32_t& child : node.child) {
      if (child == BoxNode::kNone || (child & BoxNode::kItemFlag) == 0) continue;
      const auto item = static_cast<std::uint32_t>(before.size());
      before.push_back(child & ~BoxNode::kItemFlag);
      child = item | BoxNode::kItemFlag;
    }
  }
  return before;
}

}  // namespace haptiv
