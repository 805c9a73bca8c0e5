#include "scenegraph/reading/graph/CrowdedPoints.h"

#include <algorithm>
#include <vector>

namespace haptiv {

std::string CrowdedPoints::add(const SoNode* shape, const SoMFInt32& coordIndex) {
  constexpr double kMost = 4e9;  // some three seconds; a mesh of four million triangles comes to 1e8
  if (!counted_.insert(shape).second) return {};
  const int count = coordIndex.getNum();
  const std::int32_t* index = coordIndex.getValues(0);
  const std::int32_t last = count > 0 ? *std::max_element(index, index + count) : -1;
  std::vector<int> corners(static_cast<std::size_t>(last + 1));
  for (int i = 0; i < count; ++i) {
    if (index[i] >= 0) ++corners[static_cast<std::size_t>(index[i])];
  }
  for (const int each : corners) work_ += static_cast<double>(each) * each;
  if (work_ <= kMost) return {};
  const int most = *std::max_element(corners.begin(), corners.end());
  return "has " + std::to_string(most) +
         " corners on one point, for which Coin takes too long: use several points, or fewer faces on one";
}

}  // namespace haptiv
