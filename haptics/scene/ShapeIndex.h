#pragma once

#include <cstdint>
#include <vector>

#include "haptics/index/BoundingTree.h"
#include "haptics/shapes/StraightBox.h"

namespace haptiv {

/// Walls or zones as the servo searches and measures them: derived data, made by computeBounds.
struct ShapeIndex {
  /// What a shape's distance needs first, in two lines of cache.
  struct alignas(64) Entry {
    StraightBox box;          ///< where `isStraight`
    std::uint32_t shape = 0;  ///< its number among the walls or zones
    bool isStraight = false;
    bool isUpright = false;  ///< and its box is so
  };

  BoundingTree tree;                ///< of the shapes' bounds
  std::vector<Entry> entries;       ///< item i of the tree: in its order, so that neighbours lie together
  std::vector<std::uint32_t> byId;  ///< the shapes' numbers by rising ShapeId; of equal ones the first comes first
};

/// The walls that are meshes, once more: derived data, made by computeBounds.
struct MeshIndex {
  BoundingTree tree;                ///< of their bounds
  std::vector<std::uint32_t> wall;  ///< item i is this wall
};

}  // namespace haptiv
