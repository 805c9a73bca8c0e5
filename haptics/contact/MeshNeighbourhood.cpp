#include "haptics/contact/MeshNeighbourhood.h"

namespace haptiv {

MeshNeighbourhood::MeshNeighbourhood(const HapticScene& scene, const Vector3& p_W, double likely,
                                     double certain) noexcept
    : scene_(scene), centre_(p_W), reach_(likely * (1 - 1e-9)) {
  searchWalls(
      scene, [&](const BoundingTree& tree, auto&& found) { tree.forEachWithin(p_W, certain, found); },
      [&](std::uint32_t) { isEmpty_ = false; });
  if (isEmpty_) return;
  search([&](const BoundingTree& tree, auto&& found) { tree.forEachWithin(p_W, likely, found); },
         [&](std::uint32_t wall, std::uint32_t triangle) {
           if (!isKept_) return;
           const double distance = (closest(wall, triangle, p_W) - p_W).norm();
           if (distance > likely) return;
           isKept_ = count_ < kMost;
           if (isKept_) near_[count_++] = {wall, triangle, distance};
         });
}

}  // namespace haptiv
