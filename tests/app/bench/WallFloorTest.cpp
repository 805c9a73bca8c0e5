#include "app/bench/scenes/WallFloor.h"

#include <gtest/gtest.h>

#include <set>

#include "app/bench/collision/FlatScan.h"
#include "haptics/shapes/ShapeDistance.h"

namespace haptiv {
namespace {

TEST(WallFloor, HasSoManyWallsEachWithPropertiesOfItsOwn) {
  const WallFloor floor(1000, 1);
  std::set<double> stiffnesses;
  for (const Wall& wall : floor.scene().walls) stiffnesses.insert(wall.surface.stiffness);
  EXPECT_EQ(floor.scene().walls.size(), 1000u);
  EXPECT_EQ(stiffnesses.size(), 1000u);
}

/// What the bench counts as missed contacts rests on it.
TEST(WallFloor, KnowsWhatTouchesWithoutASearch) {
  for (const double scale : {0.1, 1.0, 10.0}) {
    const WallFloor floor(200, scale);
    std::size_t touched = 0;
    for (const ToolMotion& tool : pathOver(floor, 3)) {
      bool touching = false;
      for (const Wall& wall : floor.scene().walls) {
        const double distance = nearestSurface(wall.shape, tool.position).distance;
        touching = touching || distance < tool.radius * (1 - 1e-9);
      }
      ASSERT_EQ(floor.isTouching(tool.position), touching);
      touched += touching ? 1 : 0;
    }
    EXPECT_GT(touched, 1000u);
  }
}

TEST(WallFloor, IsFeltInEveryTickInWhichTheBallTouchesItAtAnyScale) {
  for (const double scale : {0.1, 1.0, 10.0}) {
    const WallFloor floor(10000, scale);
    ContactSet contacts;
    int touching = 0, missed = 0;
    for (const ToolMotion& tool : pathOver(floor, 20)) {
      renderWalls(floor.scene(), tool, contacts);
      if (!floor.isTouching(tool.position)) continue;
      ++touching;
      missed += contacts.count == 0 ? 1 : 0;
    }
    EXPECT_GT(touching, 5000);
    EXPECT_EQ(missed, 0) << "size x" << scale;
  }
}

TEST(WallFloor, IsPassedAlongAPathWithoutJumps) {
  const WallFloor floor(10000, 1);
  const std::vector<ToolMotion> path = pathOver(floor, 20);
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_LT((path[i].position - path[i - 1].position).norm(), 0.05);
    EXPECT_LT((path[i - 1].position + 1e-3 * path[i].velocity - path[i].position).norm(), 1e-9);
  }
}

/// The peer does the same work: away from corners both say the same.
TEST(FlatScan, PushesAsTheRendererDoesOnOneWall) {
  WallFloor floor(100, 1);
  const FlatScan scan(floor.scene());
  const Vector3 middle = floor.scene().walls[22].shape.centre;
  for (double above = 0.02; above > 0.005; above -= 0.0001) {
    ContactSet contacts;
    const double top = 2 * middle.z() + floor.tile();
    const ToolMotion tool{{middle.x(), middle.y(), top + above}, Vector3::Zero(), floor.radius()};
    EXPECT_LT((scan.force(tool) - renderWalls(floor.scene(), tool, contacts)).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace haptiv
