#include "haptics/meshes/Orientation.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace haptiv {
namespace {

/// Steele, Lea and Flood's SplitMix64: every bit of the result depends on every bit of x.
std::uint64_t mixed(std::uint64_t x) noexcept {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

}  // namespace

bool hasNoRim(const std::vector<TriangleMesh::Triangle>& triangles) noexcept {
  std::uint64_t rim = 0;
  for (const TriangleMesh::Triangle& corners : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t from = corners[i], to = corners[(i + 1) % 3];
      const std::uint64_t edge = mixed(std::min(from, to) << 32 | std::max(from, to));
      rim += from < to ? edge : 0 - edge;
    }
  }
  return rim == 0 && !triangles.empty();
}

double volumeWithin(const std::vector<Vector3>& vertices,
                    const std::vector<TriangleMesh::Triangle>& triangles) noexcept {
  if (triangles.empty()) return 0;
  const Vector3 origin = vertices[triangles.front()[0]];  // on the mesh, so that one far away keeps its digits
  double volume = 0;
  for (const auto& [a, b, c] : triangles) {
    volume += (vertices[a] - origin).dot((vertices[b] - origin).cross(vertices[c] - origin));
  }
  return volume / 6;
}

}  // namespace haptiv
