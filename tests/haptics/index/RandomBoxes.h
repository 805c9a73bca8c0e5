#pragma once

#include <algorithm>
#include <vector>

#include "haptics/index/BoundingTree.h"
#include "tests/support/Random.h"

namespace haptiv::testing {

/// Boxes within a cube of half edge `size` about `centre`: large, small, flat ones, points, and some on one spot.
inline std::vector<Bounds> randomBoxes(test::Random& random, std::size_t count, double size, const Vector3& centre) {
  std::vector<Bounds> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    if (!boxes.empty() && random.between(0, 1) < 0.1) {
      boxes.push_back(boxes.back());
      continue;
    }
    const Vector3 middle = centre + random.vector<Vector3>(-size, size);
    Vector3 half = size * random.between(0, 0.05) * random.vector<Vector3>(0, 1);
    if (random.between(0, 1) < 0.2) half[static_cast<int>(random.between(0, 3))] = 0;
    if (random.between(0, 1) < 0.02) half *= 20;
    boxes.push_back({middle - half, middle + half});
  }
  return boxes;
}

/// What a flat scan says: the largest distance along an axis.
inline double gapOf(const Bounds& box, const Vector3& p) {
  return (box.low - p).cwiseMax(p - box.high).cwiseMax(0).maxCoeff();
}
inline double distanceOf(const Bounds& box, const Vector3& p) {
  return (box.low - p).cwiseMax(p - box.high).cwiseMax(0).norm();
}

inline std::vector<std::uint32_t> near(const BoundingTree& tree, const Vector3& p, double reach) {
  std::vector<std::uint32_t> found;
  tree.forEachNear(p, reach, [&](std::uint32_t item) { found.push_back(item); });
  return found;
}

inline std::vector<std::uint32_t> sorted(std::vector<std::uint32_t> items) {
  std::sort(items.begin(), items.end());
  return items;
}

}  // namespace haptiv::testing
