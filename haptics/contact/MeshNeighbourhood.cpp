#include "haptics/contact/MeshNeighbourhood.h"

namespace haptiv {

void MeshNeighbourhood::find(double likely, double certain) noexcept {
  searchWalls(
      scene_, [&](const BoundingTree& tree, auto&& found) { tree.forEachWithin(centre_, certain, found); },
      [&](std::uint32_t) { isEmpty_ = false; });
  if (isEmpty_) return;
  search([&](const BoundingTree& tree, auto&& found) { tree.forEachWithin(centre_, likely, found); },
         [&](std::uint32_t wall, std::uint32_t triangle) {
           if (!isKept_) return;
           const Vector3 at = closest(wall, triangle, centre_);
           if ((at - centre_).squaredNorm() > likely * likely) return;
           isKept_ = count_ < kMost;
           if (!isKept_) return;
           wall_[count_] = wall;
           triangle_[count_] = triangle;
           bound(count_++, centre_, at);
         });
}

}  // namespace haptiv
