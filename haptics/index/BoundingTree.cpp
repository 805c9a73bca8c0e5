#include "haptics/index/BoundingTree.h"

#include <array>
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

std::optional<std::size_t> BoundingTree::listWithin(const Vector3& p_W, double reach,
                                                    std::span<std::uint32_t> items) const noexcept {
  constexpr std::size_t kLongWalk = 128, kWidth = BoxNode::kWidth;
  std::array<std::uint32_t, kLongWalk> nodes;
  const FloatBox query = outwards(p_W, p_W, origin_);
  const float most = widened(reach);
  std::size_t listed = 0, known = 0, fetched = 1;
  if (!nodes_.empty()) nodes[known++] = 0;
  for (std::size_t next = 0; next < known; ++next) {
    if (known + kWidth > nodes.size() || listed + kWidth > items.size()) return std::nullopt;
    const BoxNode& node = nodes_[nodes[next]];
    const unsigned bits = node.within(query, most);
    for (std::size_t k = 0; k < kWidth; ++k) {  // written in any case, and then counted or not
      const std::uint32_t child = node.child[k], isItem = child >> 31U, isNear = bits >> k & 1U;
      items[listed] = child & ~BoxNode::kItemFlag;
      listed += isNear & isItem;
      nodes[known] = child;
      known += isNear & ~isItem;
    }
    for (; fetched < known; ++fetched) fetch(nodes_[nodes[fetched]]);
  }
  return listed;
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
