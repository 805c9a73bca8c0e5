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

std::optional<std::size_t> BoundingTree::copyNear(const FloatBox& query, std::span<BoxNode> nodes) const noexcept {
  std::size_t count = 0;
  bool fits = true;
  const auto copyItems = [&](const BoxNode& node) {
    const unsigned touching = fits ? node.touching(query) : 0;
    for (unsigned bits = touching; bits != 0; bits &= bits - 1) {
      const auto place = static_cast<std::size_t>(std::countr_zero(bits));
      if ((node.child[place] & BoxNode::kItemFlag) == 0) continue;
      fits = fits && count < nodes.size() * BoxNode::kWidth;
      if (!fits) return 0U;
      BoxNode& copy = nodes[count / BoxNode::kWidth];
      if (count % BoxNode::kWidth == 0) copy = BoxNode::empty();
      copy.set(count++ % BoxNode::kWidth, node.box(place), node.child[place]);
    }
    return touching;
  };
  walk(copyItems, [](std::uint32_t) {});
  return fits ? std::optional((count + BoxNode::kWidth - 1) / BoxNode::kWidth) : std::nullopt;
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
