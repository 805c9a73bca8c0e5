#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "haptics/index/NodeQueries.h"
#include "haptics/index/TreeWalk.h"

namespace haptiv {

/// Calls measure(item), which returns a distance, for the items of a tree in the order of their boxes' nearness to a
/// place, as long as a box is nearer than `reach` and than the smallest distance measured so far. Returns that
/// distance, or `reach`. A distance is not negative.
/// @param place  seen from the tree's origin
/// Realtime-safe: yes.
template <typename Measure>
double searchNearest(std::span<const BoxNode> nodes, const FloatBox& place, double reach, Measure&& measure) noexcept {
  struct Waiting {
    float squared;  ///< distance of the box [m^2]
    std::uint32_t child;
  };
  std::array<Waiting, kMostWaiting> waiting;  // farther ones below nearer ones, among the places of one node
  waiting[0] = {0, 0};
  double best = reach;
  for (std::size_t count = nodes.empty() ? 0 : 1; count > 0;) {
    const Waiting next = waiting[--count];
    if (!(double{next.squared} * WithinReach::kRounding < best * best)) continue;
    if ((next.child & BoxNode::kItemFlag) != 0) {
      best = std::min(best, measure(next.child & ~BoxNode::kItemFlag));
      continue;
    }
    const BoxNode& node = nodes[next.child];
    const std::array<float, 4> squared = node.squaredDistances(place);
    const std::size_t first = count;
    for (std::size_t i = 0; i < 4; ++i) {
      if (node.child[i] == BoxNode::kNone) continue;
      std::size_t at = count++;
      for (; at > first && waiting[at - 1].squared < squared[i]; --at) waiting[at] = waiting[at - 1];
      waiting[at] = {squared[i], node.child[i]};
    }
  }
  return best;
}

}  // namespace haptiv
