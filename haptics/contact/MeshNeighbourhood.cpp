#include "haptics/contact/MeshNeighbourhood.h"

#include <algorithm>
#include <optional>
#include <span>

#include "haptics/index/Fetch.h"

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
  std::size_t found = 0;
  searchWalls(
      scene_, [&](const BoundingTree& tree, auto&& visit) { tree.forEachWithin(centre_, likely, visit); },
      [&](std::uint32_t wall) {
        const TriangleMesh& mesh = *scene_.walls[wall].shape.mesh;
        const std::optional<std::size_t> more =
            mesh.tree.listWithin(centre_, likely, std::span(triangle_).subspan(found));
        isKept_ = isKept_ && more;
        if (!isKept_) return;
        std::fill_n(wall_.begin() + found, *more, wall);
        for (std::size_t end = found + *more; found < end; ++found) fetch(mesh.triangles[triangle_[found]]);
      });
  if (isKept_) keepNear(found, likely);
}

void MeshNeighbourhood::keepNear(std::size_t found, double reach) noexcept {
  for (std::size_t i = 0; i < found; ++i) {
    for (std::size_t k = 0; k < 3; ++k) fetch(scene_.walls[wall_[i]].shape.mesh->corner(triangle_[i], k));
  }
  TwoDistances two;
  for (std::size_t i = 0; i < found; ++i) {
    if (i % 2 == 0) measureTwo(centre_, twoFrom(i, found), two);
    keep(i, two, i % 2, reach * reach);
  }
}

TwoTriangles MeshNeighbourhood::twoFrom(std::size_t first, std::size_t found) const noexcept {
  TwoTriangles two;
  for (std::size_t lane = 0; lane < 2; ++lane) {
    const std::size_t i = std::min(first + lane, found - 1);
    const TriangleMesh& mesh = *scene_.walls[wall_[i]].shape.mesh;
    for (std::size_t k = 0; k < 3; ++k) two[lane][k] = &mesh.corner(triangle_[i], k);
  }
  return two;
}

/// Written in any case and then counted or not: nobody could foresee a jump.
void MeshNeighbourhood::keep(std::size_t i, const TwoDistances& two, std::size_t lane, double most) noexcept {
  const double squared = two.squared[lane];
  const double distance = std::sqrt(squared), perLength = distance > 0 ? 1 / distance : 0;
  wall_[count_] = wall_[i];
  triangle_[count_] = triangle_[i];
  for (std::size_t axis = 0; axis < 3; ++axis) normal_[axis][count_] = two.away[axis][lane] * perLength;
  offset_[count_] = distance - roundingAt(centre_);
  count_ += squared <= most ? 1 : 0;
}

}  // namespace haptiv
