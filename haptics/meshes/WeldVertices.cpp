#include "haptics/meshes/WeldVertices.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

namespace haptiv {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;

/// Vertices by the cell of a grid that they are in; open addressing.
class VertexGrid {
 public:
  VertexGrid(std::size_t most, double tolerance)
      : tolerance_(tolerance), slots_(std::bit_ceil(2 * most + 2), kNone), mask_(slots_.size() - 1) {}

  /// The vertex that p is one with; p itself becomes one where there is none.
  std::uint32_t vertexAt(const Vector3& p) {
    // Whoever is within the tolerance of p is in a cell that the tolerance's cube around p reaches.
    const Vector3 low = cellOf(p.array() - tolerance_), high = cellOf(p.array() + tolerance_);
    for (double x = low.x(); x <= high.x(); ++x) {
      for (double y = low.y(); y <= high.y(); ++y) {
        for (double z = low.z(); z <= high.z(); ++z) {
          const std::uint32_t found = find(slotOf({x, y, z}), p);
          if (found != kNone) return found;
        }
      }
    }
    std::size_t slot = slotOf(cellOf(p));
    while (slots_[slot] != kNone) slot = (slot + 1) & mask_;
    slots_[slot] = static_cast<std::uint32_t>(vertices.size());
    vertices.push_back(p);
    return slots_[slot];
  }

  std::vector<Vector3> vertices;

 private:
  /// Cells are four tolerances wide: a cube of two reaches one and a half of them along an axis, on average.
  Vector3 cellOf(const Vector3& p) const { return tolerance_ > 0 ? (p / (4 * tolerance_)).array().floor() : p; }

  std::size_t slotOf(const Vector3& cell) const {
    std::uint64_t hash = 0;
    for (const double number : cell) {  // + 0.0: the two zeros are one cell
      hash = (hash ^ std::bit_cast<std::uint64_t>(number + 0.0)) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 32;
    }
    return hash & mask_;
  }

  std::uint32_t find(std::size_t slot, const Vector3& p) const {
    for (; slots_[slot] != kNone; slot = (slot + 1) & mask_) {
      if ((vertices[slots_[slot]] - p).cwiseAbs().maxCoeff() <= tolerance_) return slots_[slot];
    }
    return kNone;
  }

  double tolerance_;
  std::vector<std::uint32_t> slots_;
  std::size_t mask_;
};

}  // namespace

void weldVertices(std::vector<Vector3>& vertices, std::vector<TriangleMesh::Triangle>& triangles, double tolerance) {
  VertexGrid grid(std::min(vertices.size(), 3 * triangles.size()), tolerance);
  std::vector<std::uint32_t> renamed(vertices.size(), kNone);
  std::size_t kept = 0;
  for (TriangleMesh::Triangle triangle : triangles) {
    for (std::uint32_t& corner : triangle) {
      if (renamed[corner] == kNone) renamed[corner] = grid.vertexAt(vertices[corner]);
      corner = renamed[corner];
    }
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
    triangles[kept++] = triangle;
  }
  triangles.resize(kept);
  vertices = std::move(grid.vertices);
}

}  // namespace haptiv
