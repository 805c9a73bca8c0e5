#include "haptics/index/BuildNodes.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <tuple>

#include "haptics/index/SplitItems.h"

namespace haptiv {
namespace {

/// From here on ranges are halved: 4^16 items fit into what is left of the depth.
constexpr std::size_t kLastUnevenDepth = kMaxTreeDepth - 16;
constexpr std::size_t kWidth = BoxNode::kWidth;

/// The groups that become the four places of a node.
class Places {
 public:
  Places(const ItemGroup& all, bool evenly) : evenly_(evenly) {
    place_[count_++] = all;
    while (count_ < kWidth && splitOne()) {
    }
    for (std::size_t i = 0; i < count_; ++i) {
      if (place_[i].items.size() > 1 && count_ + place_[i].items.size() - 1 <= kWidth) takeApart(i);
    }
  }
  std::size_t count() const { return count_; }
  const ItemGroup& operator[](std::size_t i) const { return place_[i]; }

 private:
  double size(const ItemGroup& group) const {
    return evenly_ ? static_cast<double>(group.items.size()) : group.halfArea();
  }
  /// Splits the largest group that does not fit into one node.
  bool splitOne() {
    ItemGroup* largest = nullptr;
    for (std::size_t i = 0; i < count_; ++i) {
      if (place_[i].items.size() <= kWidth) continue;
      if (largest == nullptr || size(place_[i]) > size(*largest)) largest = &place_[i];
    }
    if (largest == nullptr) return false;
    std::tie(*largest, place_[count_++]) = evenly_ ? halve(*largest) : splitByArea(*largest);
    return true;
  }
  /// Where there is room, items stand in this node rather than in one of their own.
  void takeApart(std::size_t i) {
    const std::span<SplitItem> items = place_[i].items;
    place_[i] = ItemGroup::of(items.first(1));
    for (std::size_t k = 1; k < items.size(); ++k) place_[count_++] = ItemGroup::of(items.subspan(k, 1));
  }

  bool evenly_;
  std::array<ItemGroup, kWidth> place_;
  std::size_t count_ = 0;
};

void build(const ItemGroup& group, std::size_t depth, std::vector<BoxNode>& nodes) {
  const std::size_t self = nodes.size();
  nodes.push_back(BoxNode::empty());
  const Places places(group, depth >= kLastUnevenDepth);
  for (std::size_t i = 0; i < places.count(); ++i) {
    const std::span<SplitItem> items = places[i].items;
    const bool isItem = items.size() == 1;
    const auto child = isItem ? items[0].index() | BoxNode::kItemFlag : static_cast<std::uint32_t>(nodes.size());
    nodes[self].set(i, places[i].box.narrow(), child);
    if (!isItem) build(places[i], depth + 1, nodes);
  }
}

}  // namespace

std::vector<BoxNode> buildNodes(const std::vector<FloatBox>& boxes) {
  std::vector<BoxNode> nodes;
  if (boxes.empty()) return nodes;
  std::vector<SplitItem> items;
  items.reserve(boxes.size());
  for (const FloatBox& box : boxes) items.emplace_back(box, static_cast<std::uint32_t>(items.size()));
  nodes.reserve(boxes.size() / 2 + 1);
  build(ItemGroup::of(items), 0, nodes);
  nodes.shrink_to_fit();
  return nodes;
}

}  // namespace haptiv
