#include "haptics/index/BuildNodes.h"

#include <algorithm>
#include <limits>
#include <span>

#include "haptics/index/SplitItems.h"

namespace haptiv {
namespace {

/// From here on ranges are halved: 4^16 items fit into what is left of the depth.
constexpr std::size_t kLastUnevenDepth = kMaxTreeDepth - 16;
constexpr std::size_t kWidth = 4;

using Range = std::span<SplitItem>;

BoxNode emptyNode() {
  constexpr float kNever = std::numeric_limits<float>::max();
  BoxNode node;
  for (std::size_t i = 0; i < kWidth; ++i) {
    node.set(i, {{kNever, kNever, kNever}, {-kNever, -kNever, -kNever}}, BoxNode::kNone);
  }
  return node;
}

/// The ranges that become the four places of a node.
class Places {
 public:
  Places(Range all, bool evenly) : count_(1) {
    range_[0] = {all, evenly ? 0 : halfArea(boxAround(all))};
    while (count_ < kWidth && splitOne(evenly)) {
    }
    for (std::size_t i = 0; i < count_; ++i) {
      if (range_[i].items.size() > 1 && count_ + range_[i].items.size() - 1 <= kWidth) takeApart(i);
    }
  }
  std::size_t count() const { return count_; }
  Range operator[](std::size_t i) const { return range_[i].items; }

 private:
  struct Place {
    Range items;
    double area = 0;
  };

  /// Splits the largest range that does not fit into one node: by area, or by number where that is to be `evenly`.
  bool splitOne(bool evenly) {
    Place* largest = nullptr;
    for (std::size_t i = 0; i < count_; ++i) {
      Place& place = range_[i];
      if (place.items.size() <= kWidth) continue;
      const bool larger = largest == nullptr || (evenly ? place.items.size() > largest->items.size()  //
                                                        : place.area > largest->area);
      if (larger) largest = &place;
    }
    if (largest == nullptr) return false;
    const Range all = largest->items;
    const std::size_t left = evenly ? halve(all) : splitByArea(all);
    const Range first = all.first(left), second = all.subspan(left);
    *largest = {first, evenly ? 0 : halfArea(boxAround(first))};
    range_[count_++] = {second, evenly ? 0 : halfArea(boxAround(second))};
    return true;
  }
  /// Where there is room, items stand in this node rather than in one of their own.
  void takeApart(std::size_t i) {
    const Range all = range_[i].items;
    range_[i].items = all.first(1);
    for (std::size_t k = 1; k < all.size(); ++k) range_[count_++].items = all.subspan(k, 1);
  }

  Place range_[kWidth];
  std::size_t count_;
};

void build(Range items, std::size_t depth, std::vector<BoxNode>& nodes) {
  const std::size_t self = nodes.size();
  nodes.push_back(emptyNode());
  const Places places(items, depth >= kLastUnevenDepth);
  for (std::size_t i = 0; i < places.count(); ++i) {
    const Range range = places[i];
    const bool isItem = range.size() == 1;
    const auto child = isItem ? range[0].index | BoxNode::kItemFlag : static_cast<std::uint32_t>(nodes.size());
    nodes[self].set(i, boxAround(range), child);
    if (!isItem) build(range, depth + 1, nodes);
  }
}

}  // namespace

std::vector<BoxNode> buildNodes(const std::vector<FloatBox>& boxes) {
  std::vector<BoxNode> nodes;
  if (boxes.empty()) return nodes;
  std::vector<SplitItem> items(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) items[i] = {boxes[i], static_cast<std::uint32_t>(i)};
  nodes.reserve(boxes.size() / 2 + 1);
  build(items, 0, nodes);
  nodes.shrink_to_fit();
  return nodes;
}

}  // namespace haptiv
