#pragma once

#include <cstdint>
#include <span>

#include "haptics/index/FloatBox.h"

namespace haptiv {

/// A box while the tree is built.
struct SplitItem {
  FloatBox box;
  std::uint32_t index = 0;
};

/// The smallest box around all of at least one.
FloatBox boxAround(std::span<const SplitItem> items) noexcept;

/// Half the surface of a box, and for boxes without a surface still something that grows with them.
double halfArea(const FloatBox& box) noexcept;

/// Sorts items into two groups that are small and lie apart, the first group first; returns its number. Both have at
/// least one item; there are at least two. Binned surface-area heuristic.
std::size_t splitByArea(std::span<SplitItem> items) noexcept;

/// The same with two halves of one size, along the longest axis.
std::size_t halve(std::span<SplitItem> items) noexcept;

}  // namespace haptiv
