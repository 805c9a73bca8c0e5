#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "haptics/geometry/Bounds.h"

namespace haptiv {

/// Four numbers that are computed side by side.
using Quad = float __attribute__((vector_size(16)));
using Quad3 = std::array<Quad, 3>;  ///< by axis

/// Four neighbouring triangles of a mesh as they are measured together: in single precision, seen from a place among
/// them, in a few lines of cache.
struct alignas(64) TriangleBlock {
  static constexpr std::size_t kSize = 4;

  std::array<Quad3, 3> corner;  ///< [m]; where the triangles end, the last one again
  Vector3 origin;               ///< in W [m]
  float size;                   ///< all corners are no farther from there along the axes; infinite: too far to tell [m]
};

using TriangleCorners = std::array<std::uint32_t, 3>;  ///< indices of vertices

/// The triangles in their order, four by four.
std::vector<TriangleBlock> makeBlocks(const std::vector<Vector3>& vertices,
                                      const std::vector<TriangleCorners>& triangles);
/// The boxes around these blocks.
std::vector<Bounds> boxesOfBlocks(std::span<const Bounds> triangles);

}  // namespace haptiv
