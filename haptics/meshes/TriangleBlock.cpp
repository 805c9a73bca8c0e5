#include "haptics/meshes/TriangleBlock.h"

#include <algorithm>
#include <limits>

namespace haptiv {
namespace {

constexpr double kMostLength = 1e9;  ///< squares of products of such lengths are numbers [m]

void set(TriangleBlock& block, std::size_t corner, std::size_t lane, const Vector3& vertex) {
  const Vector3 seen = vertex - block.origin;
  const double size = seen.cwiseAbs().sum();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double x = std::clamp(seen[static_cast<Eigen::Index>(axis)], -kMostLength, kMostLength);
    block.corner[corner][axis][lane] = static_cast<float>(x);
  }
  block.size =
      size < kMostLength ? std::max(block.size, static_cast<float>(size)) : std::numeric_limits<float>::infinity();
}

}  // namespace

std::vector<TriangleBlock> makeBlocks(const std::vector<Vector3>& vertices,
                                      const std::vector<TriangleCorners>& triangles) {
  constexpr std::size_t kSize = TriangleBlock::kSize;
  std::vector<TriangleBlock> blocks((triangles.size() + kSize - 1) / kSize);
  for (std::size_t i = 0; i < blocks.size() * kSize; ++i) {
    TriangleBlock& block = blocks[i / kSize];
    const TriangleCorners& triangle = triangles[std::min(i, triangles.size() - 1)];
    if (i % kSize == 0) block.origin = vertices[triangle[0]];
    for (std::size_t k = 0; k < 3; ++k) set(block, k, i % kSize, vertices[triangle[k]]);
  }
  return blocks;
}

std::vector<Bounds> boxesOfBlocks(std::span<const Bounds> triangles) {
  std::vector<Bounds> boxes;
  boxes.reserve(triangles.size() / TriangleBlock::kSize + 1);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (i % TriangleBlock::kSize == 0) boxes.push_back(triangles[i]);
    Bounds& box = boxes.back();
    box = {box.low.cwiseMin(triangles[i].low), box.high.cwiseMax(triangles[i].high)};
  }
  return boxes;
}

}  // namespace haptiv
