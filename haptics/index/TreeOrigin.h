#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "haptics/geometry/Bounds.h"

namespace haptiv {

/// The box around all finite boxes, kept while boxes come and go.
class BoundsOfAll {
 public:
  BoundsOfAll() noexcept;
  explicit BoundsOfAll(std::span<const Bounds> boxes) noexcept;

  void add(const Bounds& box) noexcept;
  /// Takes a box away that was added. False: it was the last one at one of the sides; nobody knows which is next, so
  /// all of them have to be added anew.
  bool remove(const Bounds& box) noexcept;
  const Bounds& bounds() const noexcept { return all_; }  ///< where there is none, low is above high

 private:
  struct Sides {
    std::array<std::uint32_t, 3> low{}, high{};
  };
  Bounds all_;
  Sides count_;  ///< of the boxes that reach so far
};

/// From where a tree sees its boxes: near the middle of all finite ones, so that single precision loses little. On a
/// coarse grid: where one of them moves, it mostly stays.
Vector3 originOf(const Bounds& all) noexcept;

}  // namespace haptiv
