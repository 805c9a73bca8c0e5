#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "haptics/laws/IfThenRenderer.h"
#include "tests/haptics/RandomShapes.h"

namespace haptiv {
namespace {

using testing::moved;
using testing::RandomShapes;
using testing::sceneOf;
using testing::wallBelow;

/// 170 N against 2000 N/m is 85 mm: seventeen times the wall.
TEST(ContactMemory, DoesNotLetTheHardestHandThroughAThinWallFromAnyDirection) {
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

TEST(ContactMemory, LetsGoOfAThinWallOnlyOnTheSideFromWhichTheBallCame) {
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
TEST(ContactMemory, HoldsTheBallInACornerHoweverDeepItIsPressed) {
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

TEST(ContactMemory, ChangesItsForceContinuouslyAlongCornersAndEdges) {
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

TEST(ContactMemory, LetsTwoWallsOnOneSpotFeelLikeOne) {
  const HapticScene scene = sceneOf({wallBelow(0.02), wallBelow(0.02)});
  ContactSet contacts;
  const Vector3 force = renderWalls(scene, {{0, 0, 0.005}, Vector3::Zero(), 0.01}, contacts);
  EXPECT_NEAR(force.z(), 10, 1e-9);
}

TEST(ContactMemory, BalancesTheBallInAGapThatIsTooNarrow) {
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

TEST(ContactMemory, KeepsItsContactThroughAnEditThatRenumbersTheWalls) {
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

TEST(ContactMemory, LetsGoOfAWallThatIsTakenAway) {
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

TEST(ContactMemory, PushesOutOfTheNearestFaceOfAWallThatAppearsAroundTheBall) {
  const HapticScene scene = sceneOf({wallBelow(0.1)});
  ContactSet contacts;
  const Vector3 force = renderWalls(scene, {{0, 0, -0.02}, Vector3::Zero(), 0.01}, contacts);
  EXPECT_NEAR(force.z(), 2000 * 0.03, 1e-9);
}

TEST(ContactMemory, KeepsTheNearestWallsWhereTooManyAreTouched) {
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
