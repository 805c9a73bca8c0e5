#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "haptics/index/Fetch.h"
#include "haptics/index/NodeQueries.h"

namespace haptiv {

/// Appends what stands in the chosen places of a node, and returns how long the list is then. Without a jump, which
/// would depend on what is near: a name is written in any case, and then counted or not, so there is to be room for
/// kWidth more.
inline std::size_t appendChildren(const BoxNode& node, unsigned chosen, std::span<std::uint32_t> list,
                                  std::size_t count) noexcept {
  for (std::size_t k = 0; k < BoxNode::kWidth; ++k) {
    list[count] = node.child[k] & ~BoxNode::kItemFlag;
    count += chosen >> k & 1U;
  }
  return count;
}

/// Lists the items of a tree that a query means, level by level: most of what is read of the tree is then on its way
/// from memory at once. Returns their number, or nothing where there are more, or where the walk is a long one.
/// @param isListed  is called with each item as soon as it is
/// Realtime-safe: yes.
template <typename Query, typename Listed>
std::optional<std::size_t> listItems(std::span<const BoxNode> nodes, const Query& query, std::span<std::uint32_t> items,
                                     Listed&& isListed) noexcept {
  constexpr std::size_t kLongWalk = 128, kWidth = BoxNode::kWidth;
  std::array<std::uint32_t, kLongWalk> way;
  std::size_t listed = 0, told = 0, known = 0, fetched = 1;
  if (!nodes.empty()) way[known++] = 0;
  for (std::size_t next = 0; next < known; ++next) {
    if (known + kWidth > way.size() || listed + kWidth > items.size()) return std::nullopt;
    const BoxNode& node = nodes[way[next]];
    const unsigned meant = query(node), withoutNode = node.withoutNode();
    listed = appendChildren(node, meant & withoutNode, items, listed);
    known = appendChildren(node, meant & ~withoutNode, way, known);
    for (; told < listed; ++told) isListed(items[told]);
    for (; fetched < known; ++fetched) fetch(nodes[way[fetched]]);
  }
  return listed;
}

/// The same of some of the nodes alone; nothing where there are more.
template <typename Query>
std::optional<std::size_t> listItemsOf(std::span<const BoxNode> nodes, std::span<const std::uint32_t> some,
                                       const Query& query, std::span<std::uint32_t> items) noexcept {
  std::size_t listed = 0;
  for (const std::uint32_t number : some) {
    if (listed + BoxNode::kWidth > items.size()) return std::nullopt;
    const BoxNode& node = nodes[number];
    listed = appendChildren(node, query(node) & node.withoutNode(), items, listed);
  }
  return listed;
}

}  // namespace haptiv
