#include <gtest/gtest.h>

#include <algorithm>

#include "haptics/laws/IfThenRenderer.h"
#include "tests/haptics/RandomShapes.h"

namespace haptiv {
namespace {

using testing::RandomShapes;
using testing::sceneOf;

constexpr double kRadius = 0.01;        // of the ball [m]
constexpr double kDepth = 0.003;        // in the higher wall [m]
const Vector3 kInwards(0, 0, -1);       // [m/s]
const Vector3 kRest = Vector3::Zero();  // [m/s]

/// A block under the ball that is pressed `below` less deep than kDepth, around the origin.
Wall blockBelow(double below, double damping) {
  Wall wall;
  wall.surface.stiffness = 1000;
  wall.surface.damping = damping;
  wall.shape.axes = Vector3(0.1, 0.1, 0.05).asDiagonal();
  wall.shape.centre = {0, 0, -0.05 - below};
  return wall;
}

/// What the walls' dampers add to the force on the ball.
Vector3 dampingForce(const HapticScene& scene, const Vector3& p, const Vector3& velocity) {
  ContactSet still, moving;
  const Vector3 atRest = renderWalls(scene, {p, kRest, kRadius}, still);
  return renderWalls(scene, {p, velocity, kRadius}, moving) - atRest;
}

Vector3 dampingForce(const HapticScene& scene) {
  return dampingForce(scene, {0, 0, kRadius - kDepth}, kInwards);
}

TEST(SharedDamping, OfTwoWallsOnOneSpotIsTheirMean) {
  const HapticScene scene = sceneOf({blockBelow(0, 10), blockBelow(0, 30)});
  EXPECT_NEAR(dampingForce(scene).z(), 20, 1e-9);
}

/// A wall joins in under the ball as it comes up from below the first: what it damps grows with its share of the depth.
TEST(SharedDamping, GrowsWithTheShareOfAWallThatJoins) {
  constexpr double kSoft = 10, kHard = 100, kStep = 1e-7;
  double last = kSoft, most = 0;
  for (double below = 0.01 * kDepth; below >= 0; below -= kStep) {
    const double now = dampingForce(sceneOf({blockBelow(0, kSoft), blockBelow(below, kHard)})).z();
    most = std::max(most, std::abs(now - last));
    last = now;
  }
  EXPECT_NEAR(last, (kSoft + kHard) / 2, 0.5);
  EXPECT_LT(most, 0.02 * (kHard - kSoft));
}

TEST(SharedDamping, OfACornerIsEachWallsOwn) {
  Wall side = blockBelow(0, 40);
  side.shape.centre = {-0.1 - kRadius + kDepth, 0, 0};
  const HapticScene scene = sceneOf({blockBelow(0, 10), side});
  const Vector3 force = dampingForce(scene, {0, 0, kRadius - kDepth}, {-2, 0, -1});
  EXPECT_LT((force - Vector3(80, 0, 10)).norm(), 1e-9);
}

/// Whatever walls hold the ball together: their dampers take energy, and never give any.
TEST(SharedDamping, OnlyTakesEnergy) {
  RandomShapes random(7);
  int shared = 0;
  for (int run = 0; run < 2000; ++run) {
    std::vector<Wall> walls(3);
    for (Wall& wall : walls) {
      wall.shape = random.shape(Shape::Kind::box, 0.03);
      wall.surface.stiffness = 1000;
      wall.surface.damping = random.between(1, 100);
    }
    const HapticScene scene = sceneOf(walls);
    const Vector3 p = random.vector(0.04), velocity = random.vector(1);
    ContactSet still, moving;
    const Vector3 atRest = renderWalls(scene, {p, kRest, kRadius}, still);
    const Vector3 force = renderWalls(scene, {p, velocity, kRadius}, moving) - atRest;
    EXPECT_LE(force.dot(velocity), 1e-9) << run;
    EXPECT_LE(force.norm(), 300 * velocity.norm()) << run;
    shared += moving.count > 1 ? 1 : 0;
  }
  EXPECT_GT(shared, 100);
}

}  // namespace
}  // namespace haptiv
