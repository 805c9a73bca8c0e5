#include "haptics/contact/MeshNeighbourhood.h"

namespace haptiv {

/// The proxy goes with its goal, or less far: what is around the middle of that way is near all of it.
void MeshNeighbourhood::findAround(const Vector3& proxy, const Vector3& step, double farthest, double radius) noexcept {
  const double way = step.norm();
  const double certain = 1.001 * (radius + farthest) + 0.5 * way;
  const double likely = std::min((1 + 1.0 / 128) * radius + 0.55 * way, certain);
  centre_ = proxy + 0.5 * step;
  reach_ = likely * (1 - 1e-9);
  find(likely, certain);
}

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
