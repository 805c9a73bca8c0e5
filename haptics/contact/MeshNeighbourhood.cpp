#include "haptics/contact/MeshNeighbourhood.h"

namespace haptiv {

void MeshNeighbourhood::measure(double likely, double certain) noexcept {
  searchWalls(
      scene_, [&](const BoundingTree& tree, auto&& found) { tree.forEachWithin(centre_, certain, found); },
      [&](std::uint32_t) { isEmpty_ = false; });
  if (isEmpty_) return;
  search([&](const BoundingTree& tree, auto&& found) { tree.forEachWithin(centre_, likely, found); },
         [&](std::uint32_t wall, std::uint32_t triangle) {
           if (!isKept_) return;
           const double distance = (closest(wall, triangle, centre_) - centre_).norm();
           if (distance > likely) return;
           isKept_ = count_ < kMost;
           if (isKept_) near_[count_++] = {wall, triangle, distance};
         });
}

}  // namespace haptiv
