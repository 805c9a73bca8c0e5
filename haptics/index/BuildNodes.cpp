#include "haptics/index/BuildNodes.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <utility>

#include "haptics/index/SplitItems.h"

namespace haptiv {
namespace {

/// From here on ranges are halved: 4^16 items fit into what is left of the depth.
constexpr std::size_t kLastUnevenDepth = kMaxTreeDepth - 16;
constexpr std::size_t kWidth = BoxNode::kWidth;
constexpr std::uint32_t kNoNode = BoxNode::kNone;

bool isNode(std::uint32_t child) {
  return (child & BoxNode::kItemFlag) == 0;
}

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
    for (std::size_t i = 0; i < count_; ++i) plan_.items[i] = static_cast<std::uint32_t>(place_[i].items.size());
  }
  std::size_t count() const { return count_; }
  const ItemGroup& operator[](std::size_t i) const { return place_[i]; }
  const TreePlan::Node& plan() const { return plan_; }

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
    const SplitGroups groups = evenly_ ? halve(*largest) : splitByArea(*largest);
    plan_.cut[count_ - 1] = {groups.choice, static_cast<std::uint8_t>(largest - place_.data())};
    plan_.isRepeatable = plan_.isRepeatable && groups.choice.slices > 0;
    *largest = groups.first;
    place_[count_++] = groups.second;
    return true;
  }
  /// Where there is room, items stand in this node rather than in one of their own.
  void takeApart(std::size_t i) {
    const std::span<SplitItem> items = place_[i].items;
    sortByIndex(items);
    place_[i] = ItemGroup::of(items.first(1));
    for (std::size_t k = 1; k < items.size(); ++k) place_[count_++] = ItemGroup::of(items.subspan(k, 1));
  }

  bool evenly_;
  std::array<ItemGroup, kWidth> place_;
  std::size_t count_ = 0;
  TreePlan::Node plan_;
};

class NodeBuilder {
 public:
  NodeBuilder(TreePlan* plan, const TreeBefore* before) : plan_(plan), before_(before) {}

  /// @param twin  the node of the tree before that stood in this place; kNoNode: none
  void build(const ItemGroup& group, std::size_t depth, std::uint32_t twin) {
    const std::size_t self = nodes_.size();
    nodes_.push_back(BoxNode::empty());
    const Places places(group, depth >= kLastUnevenDepth);
    if (plan_) plan_->nodes.push_back(places.plan());
    const bool hasTwin = twin != kNoNode && places.plan().cutsAs(before_->plan.nodes[twin]);
    for (std::size_t i = 0; i < places.count(); ++i) {
      const std::span<SplitItem> items = places[i].items;
      const bool isItem = items.size() == 1;
      const auto child = isItem ? items[0].index() | BoxNode::kItemFlag : static_cast<std::uint32_t>(nodes_.size());
      nodes_[self].set(i, places[i].box.narrow(), child);
      if (isItem) continue;
      const std::uint32_t childsTwin = hasTwin ? before_->nodes[twin].child[i] : kNoNode;
      const bool isTwinNode = childsTwin != kNoNode && isNode(childsTwin);
      if (isTwinNode && !places[i].hasNew() && items.size() == before_->plan.nodes[twin].items[i]) {
        copy(childsTwin);  // equal cuts up to here: all that stood below it still does, and nothing else
      } else {
        build(places[i], depth + 1, isTwinNode ? childsTwin : kNoNode);
      }
    }
  }

  std::vector<BoxNode> take() { return std::move(nodes_); }
  void reserve(std::size_t nodes) {
    nodes_.reserve(nodes);
    if (plan_) plan_->nodes.reserve(nodes);
  }

 private:
  /// A node of the tree before, and all below it: they stand in a row.
  void copy(std::uint32_t first) {
    const std::uint32_t last = lastBelow(first);
    const auto shift = static_cast<std::uint32_t>(nodes_.size()) - first;  // modulo 2^32
    for (std::uint32_t i = first; i <= last; ++i) {
      nodes_.push_back(before_->nodes[i]);
      plan_->nodes.push_back(before_->plan.nodes[i]);
      for (std::uint32_t& child : nodes_.back().child) {
        if (child == kNoNode) continue;
        child = isNode(child) ? child + shift : before_->itemNow[child & ~BoxNode::kItemFlag] | BoxNode::kItemFlag;
      }
    }
  }

  std::uint32_t lastBelow(std::uint32_t node) const {
    for (;;) {
      std::uint32_t last = kNoNode;
      for (const std::uint32_t child : before_->nodes[node].child) {
        if (isNode(child)) last = child;
      }
      if (last == kNoNode) return node;
      node = last;
    }
  }

  std::vector<BoxNode> nodes_;
  TreePlan* plan_;
  const TreeBefore* before_;
};

}  // namespace

std::vector<BoxNode> buildNodes(const std::vector<FloatBox>& boxes, TreePlan* plan) {
  if (plan) plan->nodes.clear();
  if (boxes.empty()) return {};
  std::vector<SplitItem> items;
  items.reserve(boxes.size());
  for (const FloatBox& box : boxes) items.emplace_back(box, static_cast<std::uint32_t>(items.size()), true);
  NodeBuilder builder(plan, nullptr);
  builder.reserve(boxes.size() / 2 + 1);
  builder.build(ItemGroup::of(items), 0, kNoNode);
  std::vector<BoxNode> nodes = builder.take();
  nodes.shrink_to_fit();
  return nodes;
}

std::vector<BoxNode> rebuildNodes(std::vector<SplitItem> items, const TreeBefore& before, TreePlan& plan) {
  plan.nodes.clear();
  if (items.empty()) return {};
  NodeBuilder builder(&plan, &before);
  builder.reserve(before.nodes.size() + 64);
  builder.build(ItemGroup::of(items), 0, before.nodes.empty() ? kNoNode : 0);
  return builder.take();
}

}  // namespace haptiv
