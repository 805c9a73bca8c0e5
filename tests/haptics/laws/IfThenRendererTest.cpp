#include "haptics/laws/IfThenRenderer.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "haptics/shapes/ShapeDistance.h"
#include "tests/haptics/RandomShapes.h"

namespace haptiv {
namespace {

using testing::moved;
using testing::RandomShapes;
using testing::sceneOf;
using testing::wallBelow;

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
  unprepared.wallIndex = {};
  for (int i = 0; i < 200; ++i) {
    const Vector3 p = placeInWall(random, scene.walls[static_cast<std::size_t>(i % 5)].shape, 0.01, 0.004);
    ContactSet a, b;
    EXPECT_EQ(renderWalls(scene, {p, p, 0.01}, a), renderWalls(unprepared, {p, p, 0.01}, b));
  }
}

}  // namespace
}  // namespace haptiv
