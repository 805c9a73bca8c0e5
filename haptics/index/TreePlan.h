#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "haptics/index/BoxNode.h"
#include "haptics/index/SplitItems.h"

namespace haptiv {

/// How a tree came to be: what it takes to build the next one, of which most boxes are the same, without going through
/// all of it again.
struct TreePlan {
  struct Node {
    /// One after the other; a group was cut `from` place 0, 1 or 2, and its second half came to the next place.
    struct Cut {
      SplitChoice choice;
      std::uint8_t from = 0;
      bool operator==(const Cut&) const = default;
    };
    std::array<Cut, BoxNode::kWidth - 1> cut{};
    bool isRepeatable = true;                            ///< all cuts are choices, none is in halves
    std::array<std::uint32_t, BoxNode::kWidth> items{};  ///< below each place

    /// Whether boxes that stood below one place of the other stand below the same place of this one.
    bool cutsAs(const Node& other) const noexcept { return isRepeatable && other.isRepeatable && cut == other.cut; }
  };
  std::vector<Node> nodes;  ///< one for each of the tree's
};

/// What is known of a tree when another one is built after it.
struct TreeBefore {
  static constexpr std::uint32_t kGone = std::numeric_limits<std::uint32_t>::max();

  std::span<const BoxNode> nodes;
  const TreePlan& plan;
  /// What each of its items is now, in the same order; kGone: it is no more, or its box is another one.
  std::span<const std::uint32_t> itemNow;
};

}  // namespace haptiv
