#pragma once

#include <bit>
#include <cstdint>
#include <span>

#include "haptics/index/FloatBox.h"

namespace haptiv {

using Float4 = Eigen::Array4f;

/// A box while the tree is built, four lanes wide for the sake of speed; the fourth means nothing.
struct WideBox {
  Float4 low = Float4::Constant(std::numeric_limits<float>::max());
  Float4 high = Float4::Constant(-std::numeric_limits<float>::max());

  void include(const WideBox& other) noexcept {
    low = low.min(other.low);
    high = high.max(other.high);
  }
  FloatBox narrow() const noexcept { return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}}; }
};

/// An item's box and, in the lanes that are free, its number and whether a tree of before lacks it.
struct SplitItem {
  SplitItem(const FloatBox& from, std::uint32_t index, bool isNew) noexcept {
    box.low << from.low[0], from.low[1], from.low[2], isNew ? -1.0F : 1.0F;
    box.high << from.high[0], from.high[1], from.high[2], std::bit_cast<float>(index);
  }
  std::uint32_t index() const noexcept { return std::bit_cast<std::uint32_t>(box.high[3]); }
  Float4 middle() const noexcept { return box.low + box.high; }  ///< twice the middle

  WideBox box;
};

/// Items that are to stand below one place of the tree.
struct ItemGroup {
  std::span<SplitItem> items;
  WideBox box;      ///< around them
  WideBox middles;  ///< around their middles

  static ItemGroup of(std::span<SplitItem> items) noexcept;
  /// Takes an item's box in; not the item.
  void include(const SplitItem& item) noexcept {
    box.include(item.box);
    middles.include({item.middle(), item.middle()});
  }
  bool hasNew() const noexcept { return box.low[3] < 0; }
  /// Half the surface of the box; where it has none, still something that grows with it.
  double halfArea() const noexcept;
};

/// A cut between two of the slices along an axis: which side an item is on depends on nothing but its own box.
struct SplitChoice {
  float low = 0;        ///< where the slices begin, and ...
  float perLength = 0;  ///< ... how many there are to a length, both for twice the middle of a box
  std::uint8_t axis = 0;
  std::uint8_t slices = 0;  ///< that go to the first group; 0: it was cut in some other way

  bool operator==(const SplitChoice&) const = default;
};

struct SplitGroups {
  ItemGroup first, second;
  SplitChoice choice;
};

/// Sorts the items into two groups that are small and lie apart, the first group first. Both have at least one item;
/// there are at least two. Binned surface-area heuristic. In which order the items are given changes neither group.
SplitGroups splitByArea(const ItemGroup& group) noexcept;

/// The same with two halves of one size, along the longest axis.
SplitGroups halve(const ItemGroup& group) noexcept;

void sortByIndex(std::span<SplitItem> items) noexcept;

}  // namespace haptiv
