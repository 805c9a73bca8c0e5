#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "haptics/index/BuildNodes.h"
#include "haptics/index/Fetch.h"

namespace haptiv {

/// Places that wait during a walk down a tree, at most: each level takes one and leaves four.
inline constexpr std::size_t kMostWaiting = 3 * kMaxTreeDepth + 1;

/// Calls visit(item) for the items of a tree that a query means, the deepest of what was met last first.
/// @param nodes  the root first
/// @param query  of NodeQueries.h
/// Realtime-safe: yes.
template <typename Query, typename Visit>
void walkTree(std::span<const BoxNode> nodes, Query&& query, Visit&& visit) noexcept {
  if (nodes.empty()) return;
  std::array<std::uint32_t, kMostWaiting> waiting;
  waiting[0] = 0;
  for (std::size_t count = 1; count > 0;) {
    const BoxNode& node = nodes[waiting[--count]];
    for (unsigned bits = query(node); bits != 0; bits &= bits - 1) {
      const std::uint32_t child = node.child[std::countr_zero(bits)];
      if ((child & BoxNode::kItemFlag) != 0) {
        visit(child & ~BoxNode::kItemFlag);
      } else {
        waiting[count++] = child;
        fetch(nodes[child]);
      }
    }
  }
}

}  // namespace haptiv
