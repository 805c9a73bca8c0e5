#include "scenegraph/reading/graph/CrowdedPoints.h"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

namespace haptiv {

void CrowdedPoints::take(std::size_t corners) {
  work_ += static_cast<double>(corners) * static_cast<double>(corners);
  most_ = std::max(most_, corners);
}

std::string CrowdedPoints::fault() const {
  constexpr double kMost = 2e9;  // some seconds, ten with a creaseAngle; a mesh of four million triangles comes to 1e8
  if (work_ <= kMost) return {};
  return "has " + std::to_string(most_) +
         " corners on one point, for which Coin takes too long: use several points, or fewer faces on one";
}

std::string CrowdedPoints::add(const SoNode* shape, const SoMFInt32& coordIndex) {
  if (!counted_.insert(shape).second) return {};
  const int count = coordIndex.getNum();
  const std::int32_t* index = coordIndex.getValues(0);
  const std::int32_t last = count > 0 ? *std::max_element(index, index + count) : -1;
  std::vector<std::size_t> corners(static_cast<std::size_t>(last + 1));
  for (int i = 0; i < count; ++i) {
    if (index[i] >= 0) ++corners[static_cast<std::size_t>(index[i])];
  }
  most_ = 0;
  for (const std::size_t each : corners) take(each);
  return fault();
}

std::string CrowdedPoints::add(const SoNode* shape, const SoMFVec3f& points, std::int64_t first, std::int64_t count) {
  if (!counted_.insert(shape).second) return {};
  using Bits = std::array<std::uint32_t, 3>;
  std::vector<Bits> sorted;
  sorted.reserve(static_cast<std::size_t>(count));
  for (std::int64_t i = first; i < first + count; ++i) {
    const SbVec3f& p = points[static_cast<int>(i)];
    const auto bits = [&](int axis) { return std::bit_cast<std::uint32_t>(p[axis] + 0.0F); };  // -0 is 0
    sorted.push_back({bits(0), bits(1), bits(2)});
  }
  std::ranges::sort(sorted);
  most_ = 0;
  for (auto begin = sorted.begin(); begin != sorted.end();) {
    const auto end = std::find_if(begin, sorted.end(), [&](const Bits& each) { return each != *begin; });
    take(static_cast<std::size_t>(end - begin));
    begin = end;
  }
  return fault();
}

}  // namespace haptiv
