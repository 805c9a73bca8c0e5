#pragma once

#include <array>
#include <bit>

#include "haptics/index/BoundingTree.h"

namespace haptiv {

/// The boxes of a tree that touch a place, copied from it a few nodes at a time: who sees that it will soon be
/// somewhere else spreads the walk down the tree over many ticks. Realtime-safe: yes.
class GatheredBoxes {
 public:
  static constexpr std::size_t kMost = 8;  ///< nodes of boxes; where they are more, none

  /// Begins with a place, as the tree's `around` or `along` returned it.
  void start(const BoundingTree& tree, const FloatBox& place) noexcept {
    place_ = place;
    boxes_ = 0;
    fits_ = true;
    waiting_[0] = 0;
    waits_ = tree.nodes().empty() ? 0 : 1;
  }

  /// Looks at so many more nodes of the same tree; calls gathered(item) for each box that is copied.
  template <typename Gathered>
  void goOn(const BoundingTree& tree, std::size_t nodes, Gathered&& gathered) noexcept {
    for (; nodes > 0 && waits_ > 0; --nodes) {
      const BoxNode& node = tree.nodes()[waiting_[--waits_]];
      for (unsigned bits = node.touching(place_); bits != 0; bits &= bits - 1) {
        const auto at = static_cast<std::size_t>(std::countr_zero(bits));
        const bool isItem = (node.child[at] & BoxNode::kItemFlag) != 0;
        fits_ = isItem ? copy(node, at) : walkLater(tree, node.child[at]);
        if (!fits_) {
          waits_ = 0;
          return;
        }
        if (isItem) gathered(node.child[at] & ~BoxNode::kItemFlag);
      }
    }
  }

  const FloatBox& place() const noexcept { return place_; }
  bool isComplete() const noexcept { return waits_ == 0; }
  /// There was room for all of them.
  bool fits() const noexcept { return fits_; }

  /// A bit for each of them that has a point in common with the query, from the lowest one on.
  std::uint32_t touching(const FloatBox& query) const noexcept {
    static_assert(kMost * BoxNode::kWidth <= 32);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < boxes_; i += BoxNode::kWidth) bits |= node_[i / BoxNode::kWidth].touching(query) << i;
    return bits;
  }
  std::uint32_t item(std::size_t box) const noexcept {
    return node_[box / BoxNode::kWidth].child[box % BoxNode::kWidth] & ~BoxNode::kItemFlag;
  }

 private:
  bool copy(const BoxNode& node, std::size_t place) noexcept {
    if (boxes_ == kMost * BoxNode::kWidth) return false;
    BoxNode& last = node_[boxes_ / BoxNode::kWidth];
    if (boxes_ % BoxNode::kWidth == 0) last = BoxNode::empty();
    last.set(boxes_++ % BoxNode::kWidth, node.box(place), node.child[place]);
    return true;
  }
  bool walkLater(const BoundingTree& tree, std::uint32_t node) noexcept {
    if (waits_ == waiting_.size()) return false;
    waiting_[waits_++] = node;
    fetch(tree.nodes()[node]);
    return true;
  }

  FloatBox place_ = FloatBox::nowhere();
  std::array<BoxNode, kMost> node_{};
  std::size_t boxes_ = 0;
  bool fits_ = true;
  std::array<std::uint32_t, 64> waiting_{};  ///< nodes of the tree
  std::size_t waits_ = 0;
};

}  // namespace haptiv
