#include "haptics/IfThenRenderer.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "haptics/ShapeDistance.h"
#include "tests/haptics/RandomShapes.h"

namespace haptiv {
namespace {

using testing::moved;
using testing::RandomShapes;
using testing::wallBelow;

HapticScene sceneOf(std::vector<Wall> walls) {
  HapticScene scene;
  scene.version = 1;
  scene.walls = std::move(walls);
  for (std::size_t i = 0; i < scene.walls.size(); ++i) scene.walls[i].id = static_cast<ShapeId>(i + 1);
  computeBounds(scene);
  return scene;
}

/// One shape of each kind as a wall, some metres from the next.
HapticScene oneOfEach(RandomShapes& random) {
  std::vector<Wall> walls(5);
  for (int i = 0; i < 5; ++i) {
    Wall& wall = walls[static_cast<std::size_t>(i)];
    wall.shape = i == 4 ? random.skewedBox() : random.shape(static_cast<Shape::Kind>(i));
    wall.shape.centre = Vector3(5.0 * i, 0, 0);
    wall.surface.stiffness = random.between(100, 5000);
    wall.surface.damping = random.between(0, 50);
  }
  return sceneOf(walls);
}

/// A place at which the ball is in the wall by `depth`, without the memory of how it came in.
Vector3 placeInWall(RandomShapes& random, const Shape& shape, double radius, double depth) {
  const Vector3 surface = random.onSurface(shape);
  const Vector3 normal = nearestSurface(shape, surface + 1e-3 * (surface - shape.centre)).normal;
  return surface + (radius - depth) * normal;
}

TEST(IfThenRenderer, FeelsNothingInTheFree) {
  const HapticScene scene = sceneOf({wallBelow(0.02)});
  ContactSet contacts;
  EXPECT_EQ(renderWalls(scene, {{0, 0, 0.0101}, {0, 0, -1}, 0.01}, contacts), Vector3::Zero());
  EXPECT_EQ(contacts.count, 0);
}

TEST(IfThenRenderer, PushesWithStiffnessTimesDepthAtRest) {
  RandomShapes random(1);
  for (int i = 0; i < 500; ++i) {
    const HapticScene scene = oneOfEach(random);
    for (const Wall& wall : scene.walls) {
      const Vector3 p = placeInWall(random, wall.shape, 0.01, random.between(0.001, 0.009));
      const SurfacePoint surface = nearestSurface(wall.shape, p);
      ContactSet contacts;
      const Vector3 force = renderWalls(scene, {p, Vector3::Zero(), 0.01}, contacts);
      const Vector3 expected = wall.surface.stiffness * (0.01 - surface.distance) * surface.normal;
      EXPECT_LT((force - expected).norm(), 1e-8);
      ASSERT_EQ(contacts.count, 1);
      EXPECT_EQ(contacts.contact[0].id, wall.id);
    }
  }
}

TEST(IfThenRenderer, DampsWhileMovingInAndNeverWhileMovingOut) {
  RandomShapes random(2);
  for (int i = 0; i < 500; ++i) {
    const HapticScene scene = oneOfEach(random);
    for (const Wall& wall : scene.walls) {
      const Vector3 p = placeInWall(random, wall.shape, 0.01, 0.005);
      const Vector3 v = random.vector(1);
      ContactSet still, moving;
      const Vector3 atRest = renderWalls(scene, {p, Vector3::Zero(), 0.01}, still);
      const Vector3 inMotion = renderWalls(scene, {p, v, 0.01}, moving);
      ASSERT_EQ(still.count, 1);
      const Vector3 normal = still.contact[0].normal;
      const double inwards = std::max(0.0, -v.dot(normal));
      EXPECT_LT((inMotion - atRest - wall.surface.damping * inwards * normal).norm(), 1e-9);
    }
  }
}

TEST(IfThenRenderer, NeverPullsTowardsTheWall) {
  RandomShapes random(3);
  for (int run = 0; run < 200; ++run) {
    const HapticScene scene = oneOfEach(random);
    const Wall& wall = scene.walls[static_cast<std::size_t>(run % 5)];
    Vector3 p = placeInWall(random, wall.shape, 0.01, 0.001);
    ContactSet contacts;
    for (int tick = 0; tick < 500; ++tick) {
      const Vector3 v = random.vector(1);
      p += 0.002 * v;
      const Vector3 force = renderWalls(scene, {p, v, 0.01}, contacts);
      for (int i = 0; i < contacts.count; ++i) {
        const Contact& contact = contacts.contact[static_cast<std::size_t>(i)];
        EXPECT_GE(contact.force.dot(contact.normal), 0);
        EXPECT_GE(contact.depth, 0);
      }
      if (contacts.count == 1) {
        EXPECT_GE(force.dot(contacts.surfacePosition - p), 0);
      }
    }
  }
}

TEST(IfThenRenderer, TurnsWithTheScene) {
  RandomShapes random(4);
  for (int run = 0; run < 100; ++run) {
    const HapticScene scene = oneOfEach(random);
    const Matrix3 R = random.rotation();
    const Vector3 t = random.vector(1);
    const HapticScene turned = moved(scene, R, t);
    Vector3 p = placeInWall(random, scene.walls[static_cast<std::size_t>(run % 5)].shape, 0.01, 0.005);
    ContactSet contacts, turnedContacts;
    for (int tick = 0; tick < 20; ++tick) {
      const Vector3 v = random.vector(1);
      p += 0.001 * v;
      const Vector3 force = renderWalls(scene, {p, v, 0.01}, contacts);
      const Vector3 turnedForce = renderWalls(turned, {R * p + t, R * v, 0.01}, turnedContacts);
      EXPECT_LT((R * force - turnedForce).norm(), 1e-6);
    }
  }
}

TEST(IfThenRenderer, FeelsTheSameWithoutPreparedBounds) {
  RandomShapes random(5);
  const HapticScene scene = oneOfEach(random);
  HapticScene unprepared = scene;
  unprepared.wallBounds.clear();
  for (int i = 0; i < 200; ++i) {
    const Vector3 p = placeInWall(random, scene.walls[static_cast<std::size_t>(i % 5)].shape, 0.01, 0.004);
    ContactSet a, b;
    EXPECT_EQ(renderWalls(scene, {p, p, 0.01}, a), renderWalls(unprepared, {p, p, 0.01}, b));
  }
}

/// 170 N against 2000 N/m is 85 mm: seventeen times the wall.
TEST(IfThenRenderer, DoesNotLetTheHardestHandThroughAThinWallFromAnyDirection) {
  RandomShapes random(6);
  for (int run = 0; run < 300; ++run) {
    const Matrix3 R = random.rotation();
    const Vector3 t = random.vector(1);
    const HapticScene scene = moved(sceneOf({wallBelow(0.005)}), R, t);
    const Vector3 towards = random.direction();
    const Vector3 hand = 170 * (R * Vector3(towards.x(), towards.y(), -std::abs(towards.z())));
    Vector3 p = R * Vector3(0, 0, 0.012) + t;
    ContactSet contacts;
    Vector3 force = Vector3::Zero();
    for (int tick = 0; tick < 2000; ++tick) {
      const double ramp = std::min(1.0, tick / 1000.0);
      const Vector3 out = R.col(2);
      force = renderWalls(scene, {p, Vector3::Zero(), 0.01}, contacts);
      p += 1e-4 * out * (ramp * hand + force).dot(out);  // without inertia: it settles as it goes
      p += 2e-4 * (hand - hand.dot(out) * out) / 170;    // and slides aside under the rest of the force
    }
    ASSERT_EQ(contacts.count, 1);
    EXPECT_NEAR(force.dot(R.col(2)), -hand.dot(R.col(2)), 0.1);
    EXPECT_NEAR(contacts.contact[0].depth, -hand.dot(R.col(2)) / 2000, 1e-4);
  }
}

TEST(IfThenRenderer, LetsGoOfAThinWallOnlyOnTheSideFromWhichTheBallCame) {
  const HapticScene scene = sceneOf({wallBelow(0.005)});
  ContactSet contacts;
  for (double z = 0.012; z > -0.08; z -= 0.001) renderWalls(scene, {{0, 0, z}, Vector3::Zero(), 0.01}, contacts);
  Vector3 force = Vector3::Zero();
  for (double z = -0.08; z < 0.0095; z += 0.001) {
    force = renderWalls(scene, {{0, 0, z}, Vector3::Zero(), 0.01}, contacts);
    EXPECT_NEAR(force.z(), 2000 * (0.01 - z), 1e-6);
  }
  force = renderWalls(scene, {{0, 0, 0.0101}, Vector3::Zero(), 0.01}, contacts);
  EXPECT_EQ(force, Vector3::Zero());
}

/// One wall ends on another's surface. The ball is pressed so deep into the first that it would pass under the second.
TEST(IfThenRenderer, HoldsTheBallInACornerHoweverDeepItIsPressed) {
  Wall across = wallBelow(0.1);
  across.shape.centre = {0.5, 0, 0.05};
  across.shape.axes = Vector3(0.0025, 2, 0.05).asDiagonal();
  const HapticScene scene = sceneOf({wallBelow(0.005), across});
  ContactSet contacts;
  Vector3 force = Vector3::Zero();
  for (double s = 0; s < 1; s += 0.001) {
    const Vector3 p(0.44 + 0.1 * s, 0, 0.011 - 0.1 * std::min(1.0, 2 * s));
    force = renderWalls(scene, {p, Vector3::Zero(), 0.01}, contacts);
  }
  EXPECT_EQ(contacts.count, 2);
  EXPECT_NEAR(force.z(), 2000 * (0.01 + 0.089), 1);
  EXPECT_NEAR(force.x(), -2000 * (0.54 - 0.4875 - 0.0001), 1);
}

TEST(IfThenRenderer, ChangesItsForceContinuouslyAlongCornersAndEdges) {
  RandomShapes random(7);
  Wall slanted = wallBelow(0.1);
  slanted.shape.axes = Eigen::AngleAxisd(0.9, Vector3::UnitY()).toRotationMatrix() * slanted.shape.axes;
  slanted.shape.centre += Vector3(0.3, 0, 0);
  const HapticScene scene = sceneOf({wallBelow(0.05), slanted});
  ContactSet contacts;
  const double step = 2e-5;
  Vector3 p(-0.5, 0, 0.005);
  Vector3 last = renderWalls(scene, {p, Vector3::Zero(), 0.01}, contacts);
  for (int tick = 0; tick < 60000; ++tick) {
    p += step * Vector3(1, 0, 0.2 * std::sin(tick * 1e-3));
    const Vector3 force = renderWalls(scene, {p, Vector3::Zero(), 0.01}, contacts);
    // Nowhere stiffer than both walls at once.
    EXPECT_LT((force - last).norm(), 2 * 2000 * 1.1 * step);
    last = force;
  }
}

TEST(IfThenRenderer, LetsTwoWallsOnOneSpotFeelLikeOne) {
  const HapticScene scene = sceneOf({wallBelow(0.02), wallBelow(0.02)});
  ContactSet contacts;
  const Vector3 force = renderWalls(scene, {{0, 0, 0.005}, Vector3::Zero(), 0.01}, contacts);
  EXPECT_NEAR(force.z(), 10, 1e-9);
}

TEST(IfThenRenderer, BalancesTheBallInAGapThatIsTooNarrow) {
  Wall above = wallBelow(0.02);
  above.shape.centre.z() += 0.035;  // a gap of 15 mm for a ball of 20 mm
  const HapticScene scene = sceneOf({wallBelow(0.02), above});
  ContactSet contacts;
  for (int tick = 0; tick < 100; ++tick) {
    const Vector3 force = renderWalls(scene, {{0, 0, 0.0075 + 0.002}, Vector3::Zero(), 0.01}, contacts);
    EXPECT_EQ(contacts.count, 2);
    EXPECT_NEAR(force.z(), -2000 * 0.004, 1e-6);
  }
}

TEST(IfThenRenderer, KeepsItsContactThroughAnEditThatRenumbersTheWalls) {
  HapticScene scene = sceneOf({wallBelow(0.005)});
  ContactSet contacts;
  for (double z = 0.012; z > -0.03; z -= 0.001) renderWalls(scene, {{0, 0, z}, Vector3::Zero(), 0.01}, contacts);
  HapticScene edited = scene;
  edited.version = 2;
  Wall other = wallBelow(0.1);
  other.id = 7;
  other.shape.centre.z() = -5;
  edited.walls.insert(edited.walls.begin(), other);
  edited.walls[1].shape.centre.z() += 0.004;  // and it was dragged a little
  computeBounds(edited);
  const Vector3 force = renderWalls(edited, {{0, 0, -0.03}, Vector3::Zero(), 0.01}, contacts);
  ASSERT_EQ(contacts.count, 1);
  EXPECT_EQ(contacts.contact[0].wall, 1);
  EXPECT_NEAR(force.z(), 2000 * 0.044, 1e-6);
}

TEST(IfThenRenderer, LetsGoOfAWallThatIsTakenAway) {
  HapticScene scene = sceneOf({wallBelow(0.005)});
  ContactSet contacts;
  for (double z = 0.012; z > -0.03; z -= 0.001) renderWalls(scene, {{0, 0, z}, Vector3::Zero(), 0.01}, contacts);
  for (const double away : {-1.0, 1.0}) {
    HapticScene edited = scene;
    edited.version = 2;
    edited.walls[0].shape.centre.z() += away;
    computeBounds(edited);
    ContactSet after = contacts;
    EXPECT_EQ(renderWalls(edited, {{0, 0, -0.03}, Vector3::Zero(), 0.01}, after), Vector3::Zero());
  }
}

TEST(IfThenRenderer, PushesOutOfTheNearestFaceOfAWallThatAppearsAroundTheBall) {
  const HapticScene scene = sceneOf({wallBelow(0.1)});
  ContactSet contacts;
  const Vector3 force = renderWalls(scene, {{0, 0, -0.02}, Vector3::Zero(), 0.01}, contacts);
  EXPECT_NEAR(force.z(), 2000 * 0.03, 1e-9);
}

TEST(IfThenRenderer, KeepsTheNearestWallsWhereTooManyAreTouched) {
  std::vector<Wall> walls(40, wallBelow(0.02));
  for (std::size_t i = 0; i < walls.size(); ++i) walls[i].shape.centre.z() -= 1e-4 * static_cast<double>(i * 7 % 40);
  const HapticScene scene = sceneOf(walls);
  ContactSet contacts;
  const Vector3 force = renderWalls(scene, {{0, 0, 0.004}, Vector3::Zero(), 0.01}, contacts);
  EXPECT_LE(contacts.count, ContactSet::kMaxContacts);
  EXPECT_NEAR(force.z(), 2000 * 0.006, 1e-6);
}

}  // namespace
}  // namespace haptiv
