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

BoundingTree::BoundingTree(std::span<const Bounds> boxes) : origin_(middleOf(boxes)), size_(boxes.size()) {
  if (size_ > kMaxItems) throw std::length_error("a bounding tree holds at most 2147483647 boxes");
  std::vector<FloatBox> rounded;
  rounded.reserve(boxes.size());
  for (const Bounds& box : boxes) rounded.push_back(outwards(box.low, box.high, origin_));
  nodes_ = buildNodes(rounded);
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
