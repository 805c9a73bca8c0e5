#include "haptics/contact/WallsAround.h"

#include <algorithm>

#include "haptics/contact/MeasuredWalls.h"
#include "haptics/index/Fetch.h"

namespace haptiv {
namespace {

/// Which walls are remembered from tick to tick.
struct WallsToRemember {
  const HapticScene& scene;
  const BallCourse& course;

  /// Somewhat farther than they are felt, and a few radii ahead of the ball; not where it is so fast that it would soon
  /// have left them behind.
  RememberedBoxes::Ahead ahead() const noexcept {
    constexpr double kMargin = 2.5, kAhead = 6, kHaste = 0.25;  // of the radius
    constexpr double kLess = 0.25;                              // of the way ahead: the margin beside it
    constexpr double kTicks = 256;
    const double radius = course.radius, most = kAhead * radius;
    if (!(course.step.squaredNorm() < kHaste * kHaste * radius * radius)) return {};
    const Vector3 way = (kTicks * course.step).cwiseMax(-most).cwiseMin(most);
    return {kMargin * radius - kLess * way.cwiseAbs().maxCoeff(), way};
  }
  /// It will be measured.
  void gathered(std::uint32_t item) const noexcept { fetch(scene.wallIndex.entries[item]); }
  /// It may soon be touched.
  std::uint32_t number(std::uint32_t item) const noexcept {
    const std::uint32_t wall = scene.wallIndex.entries[item].shape;
    fetch(scene.walls[wall].id);
    fetch(scene.walls[wall].surface);
    return wall;
  }
};

}  // namespace

void findWallsAround(const HapticScene& scene, const Vector3& place, double reach, const BallCourse& course,
                     RememberedBoxes& boxes, NearSurfaces& near) noexcept {
  const ShapeIndex& index = scene.wallIndex;
  MeasuredWalls walls(scene, place, reach, near);
  if (index.tree.size() != scene.walls.size()) return walls.search();
  const auto items = boxes.near(index.tree, place, reach, WallsToRemember{scene, course});
  if (!items || items->size() > NearSurfaces::kMost) return walls.search();
  for (std::size_t i = 0; i < items->size(); i += 2) {
    walls.measureTwo(index.entries[(*items)[i]], index.entries[(*items)[std::min(i + 1, items->size() - 1)]]);
  }
}

}  // namespace haptiv
