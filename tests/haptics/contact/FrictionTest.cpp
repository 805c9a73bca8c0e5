#include "haptics/contact/Friction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "haptics/control/Admittance.h"
#include "haptics/laws/IfThenRenderer.h"
#include "tests/haptics/RandomShapes.h"
#include "tests/haptics/meshes/SampleMeshes.h"

namespace haptiv {
namespace {

using testing::boxSoup;
using testing::kRest;
using testing::meshWall;
using testing::plateSoup;
using testing::RandomShapes;
using testing::sceneOf;
using testing::wallBelow;

Wall rough(Wall wall, double staticFriction, double dynamicFriction) {
  wall.surface.staticFriction = staticFriction;
  wall.surface.dynamicFriction = dynamicFriction;
  return wall;
}

/// A floor at z = 0, exact or of triangles.
HapticScene floorScene(bool isMesh, double staticFriction, double dynamicFriction) {
  return sceneOf({rough(isMesh ? meshWall(plateSoup(1, 13)) : wallBelow(0.1), staticFriction, dynamicFriction)});
}

class FrictionOf : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Box, FrictionOf, ::testing::Values(false));
INSTANTIATE_TEST_SUITE_P(Mesh, FrictionOf, ::testing::Values(true));

TEST_P(FrictionOf, HoldsLikeASpringWithinTheStaticCone) {
  const HapticScene scene = floorScene(GetParam(), 0.5, 0.3);
  ContactSet contacts;
  renderWalls(scene, {{0, 0, 0.02}, kRest, 0.01}, contacts);
  for (double z = 0.01; z > 0.006; z -= 1e-4) renderWalls(scene, {{0, 0, z}, kRest, 0.01}, contacts);
  for (const double x : {0.0, 0.001, 0.0019, -0.0019, 0.0005, 0.0}) {
    const Vector3 force = renderWalls(scene, {{x, 0, 0.006}, kRest, 0.01}, contacts);
    EXPECT_LT((force - 2000 * Vector3(-x, 0, 0.004)).norm(), 1e-3) << x;
    EXPECT_FALSE(contacts.sliding);
  }
}

TEST_P(FrictionOf, SlidesWithTheDynamicForceAgainstTheMotion) {
  const HapticScene scene = floorScene(GetParam(), 0.5, 0.3);
  ContactSet contacts;
  const Vector3 way(0.6, 0.8, 0);
  renderWalls(scene, {{0, 0, 0.02}, kRest, 0.01}, contacts);
  for (int i = 0; i < 2000; ++i) {
    const double gone = 1e-5 * i;
    const Vector3 force = renderWalls(scene, {gone * way + Vector3(0, 0, 0.006), kRest, 0.01}, contacts);
    EXPECT_NEAR(force.z(), 8, 1e-3);
    const bool isYielding = i == 201;  // from 4 N to 2.4 N, 1.25 N in a tick
    const double pull = isYielding ? 2000 * (0.002 - 0.01 / 16) : gone > 0.002 + 1e-9 ? 0.3 * 8 : 2000 * gone;
    EXPECT_LT((Vector3(force.x(), force.y(), 0) + pull * way).norm(), 1e-3) << i;
  }
}

TEST(Friction, OfZeroIsBitForBitNone) {
  RandomShapes random(1);
  for (int run = 0; run < 20; ++run) {
    Wall wall = run % 2 == 0 ? meshWall(boxSoup(kRest, 0.05 * Matrix3::Identity(), 3)) : Wall();
    if (run % 2 != 0) wall.shape = random.shape(Shape::Kind::cylinder, 0.1);
    const HapticScene smooth = sceneOf({wall}), zero = sceneOf({rough(wall, 0, 0.7)});
    ContactSet a, b;
    Vector3 p = 0.2 * random.direction();
    for (int tick = 0; tick < 300; ++tick) {
      p += 1e-3 * (random.vector(1) - 10 * (p - wall.shape.centre));
      const Vector3 v = random.vector(0.1);
      EXPECT_EQ(renderWalls(smooth, {p, v, 0.01}, a), renderWalls(zero, {p, v, 0.01}, b));
    }
  }
}

/// Along a path that begins and ends in the free, the force does no work on the ball but what is lost.
TEST_P(FrictionOf, NeverGivesEnergy) {
  RandomShapes random(2);
  for (int run = 0; run < 60; ++run) {
    const double dynamic = random.between(0, 1);
    const double most = dynamic + random.between(0, 0.5);
    Wall wall = GetParam() ? meshWall(boxSoup(kRest, 0.05 * Matrix3::Identity(), 4)) : Wall();
    if (!GetParam()) wall.shape.axes = 0.05 * Matrix3::Identity();
    const HapticScene scene = sceneOf({rough(wall, most, dynamic)});
    ContactSet contacts;
    Vector3 p(0, 0, 0.07), last = renderWalls(scene, {p, kRest, 0.01}, contacts);
    double work = 0, lost = 0;
    const Vector3 target(random.between(-0.03, 0.03), random.between(-0.03, 0.03), 0.055);
    Vector3 v = kRest;
    for (int tick = 0; tick < 6000; ++tick) {
      const Vector3 to = tick < 5000 ? target : Vector3(0, 0, 0.1);
      v += 0.02 * (0.02 * random.vector(1) + 0.5 * (to - p) - v);
      const Vector3 way = 1e-3 * v;
      p += way;
      const Vector3 force = renderWalls(scene, {p, kRest, 0.01}, contacts);
      work += 0.5 * (last + force).dot(way);
      lost += std::abs(0.5 * (last + force).dot(way));
      last = force;
    }
    ASSERT_EQ(contacts.count, 0);
    EXPECT_LT(work, 1e-3 * lost + 1e-9) << run;  // the trapezium's error of a slip within a tick
  }
}

TEST_P(FrictionOf, ChangesItsForceContinuouslyWhereBothCoefficientsAreOne) {
  RandomShapes random(3);
  for (int run = 0; run < 20; ++run) {
    const double mu = random.between(0.1, 1);
    Wall wall = GetParam() ? meshWall(boxSoup(kRest, 0.05 * Matrix3::Identity(), 4)) : Wall();
    if (!GetParam()) wall.shape.axes = 0.05 * Matrix3::Identity();
    const HapticScene scene = sceneOf({rough(wall, mu, mu)});
    ContactSet contacts;
    Vector3 p(0, 0, 0.065), v = kRest;
    Vector3 last = renderWalls(scene, {p, kRest, 0.01}, contacts);
    for (int tick = 0; tick < 5000; ++tick) {
      v += 0.02 * (0.1 * random.vector(1) + (Vector3(0, 0, 0.056) - p) - v);
      p += 1e-3 * v;
      const Vector3 force = renderWalls(scene, {p, kRest, 0.01}, contacts);
      EXPECT_LT((force - last).norm(), 2000 * (1 + 2 * mu) * 1e-3 * v.norm() + 0.01) << tick;
      last = force;
    }
  }
}

/// The step of force where the ball breaks away is what the two coefficients are apart.
TEST_P(FrictionOf, StepsByTheDifferenceOfTheCoefficientsAtMost) {
  RandomShapes random(4);
  const HapticScene scene = floorScene(GetParam(), 0.6, 0.2);
  ContactSet contacts;
  Vector3 p(0, 0, 0.012), v = kRest;
  Vector3 last = renderWalls(scene, {p, kRest, 0.01}, contacts);
  for (int tick = 0; tick < 20000; ++tick) {
    v += 0.02 * (0.2 * random.vector(1) + (Vector3(0, 0, 0.004) - p) - v);
    p += 1e-3 * v;
    const Vector3 force = renderWalls(scene, {p, kRest, 0.01}, contacts);
    EXPECT_LT((force - last).norm(), 0.4 * std::max(force.z(), last.z()) + 2000 * 2.3e-3 * v.norm() + 1e-3);
    last = force;
  }
}

/// Deep in a soft floor the ball may come into a stiff wall while the proxy sticks beside it. As it breaks loose, the
/// wall takes hold bit by bit: by a slip of the proxy in a tick.
TEST(Friction, LetsANeighbourTakeHoldBitByBitWhereItBreaksLoose) {
  Wall soft = rough(wallBelow(1, 20, 0), 0.5, 0), stiff = wallBelow(1, 10000, 0);
  stiff.shape.axes = Eigen::AngleAxisd(-std::numbers::pi / 2, Vector3::UnitY()).toRotationMatrix() * stiff.shape.axes;
  stiff.shape.centre = {0.5, 0, 0};
  const HapticScene scene = sceneOf({soft, stiff});
  ContactSet contacts;
  Vector3 p(-0.011, 0, 0.011), last = renderWalls(scene, {p, kRest, 0.01}, contacts);
  double deepest = 0, most = 0;
  for (int tick = 0; tick < 4500; ++tick) {
    const Vector3 way = tick < 2000 ? Vector3(0, 0, -1e-5) : Vector3(1e-5, 0, 0);
    p += way;
    const Vector3 force = renderWalls(scene, {p, kRest, 0.01}, contacts);
    EXPECT_LT((force - last).norm(), 10000 * (0.01 / 16 + 4e-5)) << tick;
    if (contacts.count == 1) deepest = std::max(deepest, p.x() + 0.01);
    most = std::max(most, -force.x());
    last = force;
  }
  EXPECT_GT(deepest, 0.005) << "it came into the wall while it stuck";
  EXPECT_GT(most, 0.9 * 10000 * 0.015) << "and was held by it in the end";
}

/// Two floors side by side with other coefficients and another stiffness: the pull passes over from one to the other.
TEST(Friction, PassesContinuouslyFromOneWallToTheNext) {
  Wall left = rough(wallBelow(0.1), 0.5, 0.5), right = rough(wallBelow(0.1), 0.2, 0.2);
  left.shape.centre.x() = -2;
  right.shape.centre.x() = 2;
  right.shape.axes = Eigen::AngleAxisd(-0.1, Vector3::UnitY()).toRotationMatrix() * right.shape.axes;
  right.shape.centre.z() = right.shape.axes.col(0).z() + right.shape.centre.z();
  right.surface.stiffness = 1000;
  const HapticScene scene = sceneOf({left, right});
  ContactSet contacts;
  Vector3 p(-0.02, 0, 0.011), last = renderWalls(scene, {p, kRest, 0.01}, contacts);
  for (int tick = 0; tick < 8000; ++tick) {
    const Vector3 way = tick < 500 ? Vector3(0, 0, -1e-5) : Vector3(1e-5, 0, 0);
    p += way;
    const Vector3 force = renderWalls(scene, {p, kRest, 0.01}, contacts);
    // Both walls and both pulls at once, and the stiffness that the pull has, going over from one to the other.
    EXPECT_LT((force - last).norm(), 4 * 2000 * 2 * 1e-5) << tick;
    last = force;
  }
}

/// 10 N down, and a push to the side: below mu_s N it holds, above it the rest of the push accelerates the ball.
TEST_P(FrictionOf, HoldsAPushBelowTheStaticForceAndYieldsToOneAbove) {
  for (const double push : {4.5, 7.0}) {
    const HapticScene scene = floorScene(GetParam(), 0.5, 0.3);
    ContactSet contacts;
    AdmittanceState ball;
    ball.position = {0, 0, 0.005};  // at rest under 10 N
    Vector3 walls = kRest;
    renderWalls(scene, {{0, 0, 0.02}, kRest, 0.01}, contacts);
    for (int tick = 0; tick < 1000; ++tick) {
      walls = renderWalls(scene, {ball.position, ball.velocity, 0.01}, contacts);
      // The ball's own damping lets the tangential spring come to rest.
      const Vector3 force = walls + Vector3(std::min(1.0, tick / 500.0) * push, 0, -10) - 20 * ball.velocity;
      ball.velocity = nextVelocity(ball, force, 2, 1e-3);
      ball.position += 1e-3 * ball.velocity;
    }
    if (push < 5) {
      EXPECT_NEAR(ball.position.x(), push / 2000, 2e-4);
      EXPECT_FALSE(contacts.sliding);
    } else {
      EXPECT_NEAR(walls.x(), -0.3 * 10, 1e-2);
      EXPECT_GT(ball.position.x(), 0.005);
      EXPECT_TRUE(contacts.sliding);
    }
  }
}

}  // namespace
}  // namespace haptiv
