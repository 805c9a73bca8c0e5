#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "device/types.h"
#include "haptics/index/BoundingTree.h"
#include "haptics/meshes/TriangleBlock.h"

namespace haptiv {

/// A surface of triangles, in W. Immutable once it stands in a scene; made by makeTriangleMesh.
struct TriangleMesh {
  using Triangle = TriangleCorners;  ///< indices into `vertices`, counter-clockwise seen from outside

  static constexpr double kFar = 1e100;  ///< beyond it nothing is felt: squares of lengths overflow [m]

  std::vector<Vector3> vertices;      ///< [m]; corners on one spot are one vertex
  std::vector<Triangle> triangles;    ///< neighbours in space are near each other here too
  std::vector<TriangleBlock> blocks;  ///< the same, kSize by kSize
  bool closed = false;                ///< bounds a volume: every edge is passed as often one way as the other
  Bounds bounds;                      ///< around all of it
  BoundingTree tree;                  ///< finds blocks near a place

  const Vector3& corner(std::size_t triangle, std::size_t i) const noexcept { return vertices[triangles[triangle][i]]; }

  /// Calls visit(triangle) for those of a block.
  template <typename Visit>
  void forEachOf(std::size_t block, Visit&& visit) const {
    const std::size_t first = block * TriangleBlock::kSize;
    for (std::size_t i = first; i < std::min(first + TriangleBlock::kSize, triangles.size()); ++i) visit(i);
  }
  /// One bit for each of a block's places that has a triangle.
  unsigned lanesOf(std::size_t block) const noexcept {
    constexpr unsigned kAll = (1U << TriangleBlock::kSize) - 1;
    const std::size_t left = triangles.size() - block * TriangleBlock::kSize;
    return left < TriangleBlock::kSize ? kAll >> (TriangleBlock::kSize - left) : kAll;
  }
};

/// A mesh of triangles as they come from a file.
///
/// Corners nearer to each other than a millionth of the mesh's size, or than single precision tells apart, become one
/// vertex. Triangles that have two corners on one spot, corners that are not finite or beyond kFar, or indices beyond
/// the vertices, are dropped; so are vertices that no triangle has. A closed mesh whose triangles face inwards is
/// turned inside out. The same input gives the same mesh. O(n log n); null where no triangle is left.
std::shared_ptr<const TriangleMesh> makeTriangleMesh(const std::vector<Vector3>& vertices,
                                                     const std::vector<TriangleMesh::Triangle>& triangles);

/// A mesh of vertices and triangles that were once made by makeTriangleMesh: they are kept as they are, so that a log
/// re-simulates bit for bit. Indices must be in range.
std::shared_ptr<const TriangleMesh> restoreTriangleMesh(std::vector<Vector3> vertices,
                                                        std::vector<TriangleMesh::Triangle> triangles);

}  // namespace haptiv
