#include "haptics/meshes/OrderTriangles.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

namespace haptiv {
namespace {

struct Middle {
  std::array<double, 3> place;
  std::uint32_t triangle;
};

/// The axis along which they lie farthest apart.
std::size_t longestAxis(std::span<const Middle> middles) {
  std::array<double, 3> low = middles.front().place, high = low;
  for (const Middle& middle : middles) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], middle.place[axis]);
      high[axis] = std::max(high[axis], middle.place[axis]);
    }
  }
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis) {
    if (high[axis] - low[axis] > high[longest] - low[longest]) longest = axis;
  }
  return longest;
}

/// Halves them again and again along their longest axis, between blocks.
void sortInSpace(std::span<Middle> middles) {
  constexpr std::size_t kBlock = TriangleBlock::kSize;
  while (middles.size() > kBlock) {
    const std::size_t axis = longestAxis(middles), half = (middles.size() / 2 + kBlock - 1) / kBlock * kBlock;
    const auto cut = middles.begin() + static_cast<std::ptrdiff_t>(half);
    std::nth_element(middles.begin(), cut, middles.end(), [axis](const Middle& one, const Middle& other) {
      return std::pair(one.place[axis], one.triangle) < std::pair(other.place[axis], other.triangle);
    });
    sortInSpace(middles.first(half));
    middles = middles.subspan(half);
  }
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
  std::vector<Middle> middles;
  middles.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    const Vector3 middle = vertices[a] / 3 + vertices[b] / 3 + vertices[c] / 3;
    middles.push_back({{middle.x(), middle.y(), middle.z()}, static_cast<std::uint32_t>(middles.size())});
  }
  sortInSpace(middles);
  std::vector<TriangleMesh::Triangle> ordered;
  ordered.reserve(triangles.size());
  for (const Middle& middle : middles) ordered.push_back(triangles[middle.triangle]);
  triangles = std::move(ordered);
  orderVertices(vertices, triangles);
}

}  // namespace haptiv
