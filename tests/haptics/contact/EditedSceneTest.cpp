#include <gtest/gtest.h>

#include <algorithm>

#include "haptics/laws/IfThenRenderer.h"
#include "haptics/scene/SceneFade.h"
#include "haptics/shapes/ShapeDistance.h"
#include "tests/haptics/RandomShapes.h"
#include "tests/haptics/meshes/SampleMeshes.h"

namespace haptiv {
namespace {

using testing::boxSoup;
using testing::meshWall;
using testing::moved;
using testing::plateSoup;
using testing::RandomShapes;

/// A wall of any kind near the ball, rough and with hysteresis.
Wall randomWall(RandomShapes& random, ShapeId id) {
  Wall wall;
  const int kind = static_cast<int>(random.between(0, 5.999));
  if (kind < 4) {
    wall.shape = random.shape(static_cast<Shape::Kind>(kind), 0.03);
  } else {
    const testing::Soup soup = kind == 4 ? plateSoup(0.04, 2) : boxSoup(Vector3::Zero(), 0.03 * Matrix3::Identity(), 2);
    wall = meshWall(moved(soup, random.rotation(), random.vector(0.03)));
  }
  wall.id = id;
  wall.surface = {random.between(100, 2000), 0, random.between(0, 1e-3), random.between(0, 1), random.between(0, 1)};
  return wall;
}

void edit(RandomShapes& random, HapticScene& scene) {
  ++scene.version;
  const auto which = static_cast<std::size_t>(random.between(0, 3.999));
  if (which == 0 || scene.walls.empty()) {
    scene.walls.push_back(randomWall(random, scene.version));
  } else if (which == 1) {
    scene.walls.erase(scene.walls.begin());
  } else if (which == 2) {
    scene.walls.back() = randomWall(random, scene.walls.back().id);  // moved, or made another shape
  } else {
    scene.walls.back().surface.stiffness = random.between(100, 2000);
  }
  if (scene.walls.size() > 4) scene.walls.pop_back();
  computeBounds(scene);
}

/// Whether the walls leave room for the ball in the place to which they let it come.
bool hasRoom(const HapticScene& scene, const Vector3& place) {
  return std::all_of(scene.walls.begin(), scene.walls.end(),
                     [&](const Wall& wall) { return nearestSurface(wall.shape, place).distance > 0.01 * (1 - 1e-3); });
}

/// A ball at rest, and walls that come, go, move and stiffen around it: the force goes from where it was to where it
/// will be within the fade. Where walls overlap so that there is no room for the ball, any force is a compromise.
TEST(AnEditedScene, NeverStepsTheForce) {
  RandomShapes random(1);
  HapticScene scene;
  ContactSet contacts;
  SceneFade fade;
  Vector3 last = Vector3::Zero();
  int judged = 0;
  for (int version = 0; version < 400; ++version) {
    edit(random, scene);
    Vector3 raw = renderWalls(scene, {Vector3::Zero(), Vector3::Zero(), 0.01}, contacts);
    const bool isFair = hasRoom(scene, contacts.surfacePosition);
    const double largest = std::max(last.norm(), raw.norm());
    judged += isFair ? 1 : 0;
    for (int tick = 0; tick < 120; ++tick) {
      const Vector3 felt = fade.apply(scene, raw, 1e-3);
      // A hundredth a tick of a way that is twice the larger force at most.
      if (isFair) {
        EXPECT_LE((felt - last).norm(), 0.0101 * 2 * largest + 1e-3) << version << " " << tick;
      }
      EXPECT_TRUE(felt.allFinite());
      last = felt;
      raw = renderWalls(scene, {Vector3::Zero(), Vector3::Zero(), 0.01}, contacts);
    }
    EXPECT_LT((last - raw).norm(), isFair ? 1e-3 : 1e3);
  }
  EXPECT_GT(judged, 200);
}

/// Thick walls all around, among which the ball has no place. Whatever force that makes, it comes slowly.
TEST(AnEditedScene, NeverStepsTheForceOnABallInAGapNarrowerThanItself) {
  RandomShapes random(2);
  HapticScene scene;
  ContactSet contacts;
  SceneFade fade;
  Vector3 last = Vector3::Zero();
  int narrow = 0;
  for (int version = 1; version < 300; ++version) {
    scene.walls.clear();
    for (int i = 0; i < 2 + version % 4; ++i) {
      Wall& wall = scene.walls.emplace_back();
      const Matrix3 R = random.rotation();
      const Vector3 half(random.between(0.02, 0.05), random.between(0.02, 0.05), random.between(0.005, 0.05));
      wall.id = static_cast<ShapeId>(i + 1);
      wall.shape.axes = R * half.asDiagonal();
      wall.shape.centre = -(half.z() + random.between(-0.004, 0.009)) * R.col(2);
      wall.surface.stiffness = random.between(100, 2000);
    }
    scene.version = static_cast<std::uint32_t>(version);
    computeBounds(scene);
    Vector3 raw = renderWalls(scene, {Vector3::Zero(), Vector3::Zero(), 0.01}, contacts);
    narrow += hasRoom(scene, contacts.surfacePosition) ? 0 : 1;
    const double largest = std::max(last.norm(), raw.norm());
    for (int tick = 0; tick < 120; ++tick) {
      const Vector3 felt = fade.apply(scene, raw, 1e-3);
      EXPECT_LE((felt - last).norm(), 0.0101 * 2 * largest + 1e-3) << version << " " << tick;
      last = felt;
      raw = renderWalls(scene, {Vector3::Zero(), Vector3::Zero(), 0.01}, contacts);
    }
  }
  EXPECT_GT(narrow, 10);
}

}  // namespace
}  // namespace haptiv
