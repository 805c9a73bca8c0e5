#include "haptics/index/BoundingTree.h"

#include <stdexcept>

namespace haptiv {
namespace {

/// The middle of all finite boxes: seen from there, single precision loses least.
Vector3 middleOf(std::span<const Bounds> boxes) {
  constexpr double kEnd = std::numeric_limits<double>::max() / 2;
  Vector3 low = Vector3::Constant(kEnd), high = Vector3::Constant(-kEnd);
  for (const Bounds& box : boxes) {
    if (!box.low.allFinite() || !box.high.allFinite()) continue;
    low = low.cwiseMin(box.low);
    high = high.cwiseMax(box.high);
  }
  const Vector3 middle = 0.5 * low + 0.5 * high;
  return middle.allFinite() ? middle : Vector3::Zero();
}

}  // namespace

BoundingTree::BoundingTree(std::span<const Bounds> boxes)
    : origin_(middleOf(boxes)), farOff_(origin_.cwiseAbs().sum()), size_(boxes.size()) {
  if (size_ > kMaxItems) throw std::length_error("a bounding tree holds at most 2147483647 boxes");
  std::vector<FloatBox> rounded;
  rounded.reserve(boxes.size());
  for (const Bounds& box : boxes) rounded.push_back(outwards(box.low, box.high, origin_));
  nodes_ = buildNodes(rounded);
}

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
