#include "haptics/meshes/OrderTriangles.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace haptiv {
namespace {

constexpr int kBits = 21;  ///< an axis: three of them fit into 64

/// The bits of a number of kBits, each followed by two zeros.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x1f00000000ffffU;
  x = (x | x << 16) & 0x1f0000ff0000ffU;
  x = (x | x << 8) & 0x100f00f00f00f00fU;
  x = (x | x << 4) & 0x10c30c30c30c30c3U;
  return (x | x << 2) & 0x1249249249249249U;
}

std::uint64_t mortonCode(const Vector3& p, const Vector3& low, double perCell) {
  constexpr double kLast = (1 << kBits) - 1;
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double cell = std::clamp((p[axis] - low[axis]) * perCell, 0.0, kLast);
    code = code << 1 | spread(static_cast<std::uint64_t>(cell));
  }
  return code;
}

std::vector<std::uint64_t> mortonCodes(const std::vector<Vector3>& vertices,
                                       const std::vector<TriangleMesh::Triangle>& triangles) {
  Vector3 low = vertices.front(), high = low;
  for (const Vector3& p : vertices) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double size = (high - low).maxCoeff();
  const double perCell = size > 0 ? (1 << kBits) / size : 0;
  std::vector<std::uint64_t> codes;
  codes.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    const Vector3 middle = (vertices[a] + vertices[b] + vertices[c]) / 3;
    codes.push_back(mortonCode(middle, low, perCell));
  }
  return codes;
}

void orderVertices(std::vector<Vector3>& vertices, std::vector<TriangleMesh::Triangle>& triangles) {
  constexpr std::uint32_t kNone = 0xffffffffU;
  std::vector<std::uint32_t> renamed(vertices.size(), kNone);
  std::vector<Vector3> ordered;
  ordered.reserve(vertices.size());
  for (TriangleMesh::Triangle& triangle : triangles) {
    for (std::uint32_t& corner : triangle) {
      if (renamed[corner] == kNone) {
        renamed[corner] = static_cast<std::uint32_t>(ordered.size());
        ordered.push_back(vertices[corner]);
      }
      corner = renamed[corner];
    }
  }
  ordered.shrink_to_fit();
  vertices = std::move(ordered);
}

}  // namespace

void orderTriangles(std::vector<Vector3>& vertices, std::vector<TriangleMesh::Triangle>& triangles) {
  if (triangles.empty()) {
    vertices.clear();
    return;
  }
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
  order.reserve(triangles.size());
  for (const std::uint64_t code : mortonCodes(vertices, triangles)) {
    order.emplace_back(code, static_cast<std::uint32_t>(order.size()));
  }
  std::sort(order.begin(), order.end());
  std::vector<TriangleMesh::Triangle> ordered;
  ordered.reserve(triangles.size());
  for (const auto& [code, index] : order) ordered.push_back(triangles[index]);
  triangles = std::move(ordered);
  orderVertices(vertices, triangles);
}

}  // namespace haptiv
