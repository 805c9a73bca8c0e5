#include "haptics/laws/Zones.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/haptics/RandomShapes.h"
#include "tests/haptics/meshes/SampleMeshes.h"

namespace haptiv {
namespace {

using testing::moved;
using testing::RandomShapes;

Zone boxZone(Zone::Kind kind) {
  Zone zone;
  zone.id = 1;
  zone.kind = kind;
  zone.shape.axes = Vector3(0.1, 0.1, 0.1).asDiagonal();
  zone.anchor = {0.02, 0, 0};
  return zone;
}

HapticScene sceneWith(std::vector<Zone> zones) {
  HapticScene scene;
  scene.zones = std::move(zones);
  computeBounds(scene);
  return scene;
}

Vector3 forceAt(const HapticScene& scene, const Vector3& p, const Vector3& v, int* inside = nullptr) {
  int count = 0;
  const Vector3 force = renderZones(scene, {p, v, 0.01}, count);
  if (inside != nullptr) *inside = count;
  return force;
}

TEST(ViscousZone, ActsAgainstTheVelocity) {
  int inside = 0;
  const Vector3 force = forceAt(sceneWith({boxZone(Zone::Kind::viscous)}), {0, 0, 0}, {0.1, -0.2, 0.3}, &inside);
  EXPECT_LT((force + 15 * Vector3(0.1, -0.2, 0.3)).norm(), 1e-12);
  EXPECT_EQ(inside, 1);
}

TEST(SpringZone, PullsToItsAnchor) {
  const Vector3 force = forceAt(sceneWith({boxZone(Zone::Kind::spring)}), {0, 0.03, 0}, {1, 1, 1});
  EXPECT_LT((force - 150 * Vector3(0.02, -0.03, 0)).norm(), 1e-12);
}

TEST(SpringZone, PushesAwayWhereItIsShorterThanItsRestLength) {
  Zone zone = boxZone(Zone::Kind::spring);
  zone.restLength = 0.05;
  const HapticScene scene = sceneWith({zone});
  EXPECT_NEAR(forceAt(scene, {0.02, 0.02, 0}, Vector3::Zero()).y(), 150 * 0.03, 1e-12);
  EXPECT_NEAR(forceAt(scene, {0.02, 0.07, 0}, Vector3::Zero()).y(), -150 * 0.02, 1e-12);
}

TEST(SpringZone, IsFiniteInItsAnchor) {
  Zone zone = boxZone(Zone::Kind::spring);
  for (const double restLength : {0.0, 0.05}) {
    zone.restLength = restLength;
    EXPECT_EQ(forceAt(sceneWith({zone}), zone.anchor, Vector3::Zero()), Vector3::Zero());
    const Vector3 near = forceAt(sceneWith({zone}), zone.anchor + Vector3(0, 1e-300, 0), Vector3::Zero());
    EXPECT_LE(near.norm(), 150 * restLength + 1e-12);
  }
}

TEST(RubberBand, PullsOnlyWhereItIsLongerThanItsRestLength) {
  Zone zone = boxZone(Zone::Kind::rubberBand);
  zone.restLength = 0.05;
  const HapticScene scene = sceneWith({zone});
  EXPECT_EQ(forceAt(scene, {0.02, 0.04, 0}, {1, 1, 1}), Vector3::Zero());
  EXPECT_LT((forceAt(scene, {0.02, 0.07, 0}, {1, 1, 1}) - Vector3(0, -150 * 0.02, 0)).norm(), 1e-12);
  EXPECT_EQ(forceAt(scene, zone.anchor, {1, 1, 1}), Vector3::Zero());
}

TEST(RubberBand, TakesHoldContinuouslyAtItsRestLength) {
  Zone zone = boxZone(Zone::Kind::rubberBand);
  zone.restLength = 0.05;
  const HapticScene scene = sceneWith({zone});
  Vector3 last = Vector3::Zero();
  for (double y = 0; y < 0.08; y += 1e-5) {
    const Vector3 force = forceAt(scene, {0.02, y, 0}, Vector3::Zero());
    EXPECT_LE((force - last).norm(), 150 * 1e-5 * 1.001);
    last = force;
  }
  EXPECT_LT(last.y(), 0);
}

TEST(Zones, AreBoundedByClosedMeshesAsByTheShapesTheyAre) {
  RandomShapes random(3);
  Zone exact = boxZone(Zone::Kind::viscous), mesh = exact, open = exact;
  mesh.shape.kind = open.shape.kind = Shape::Kind::mesh;
  mesh.shape.mesh = testing::boxSoup(exact.shape.centre, exact.shape.axes, 3).mesh();
  testing::Soup soup = testing::boxSoup(exact.shape.centre, exact.shape.axes, 3);
  soup.triangles.pop_back();
  open.shape.mesh = soup.mesh();
  for (int i = 0; i < 2000; ++i) {
    const Vector3 p = random.vector(0.12), v = random.vector(1);
    EXPECT_LT((forceAt(sceneWith({exact}), p, v) - forceAt(sceneWith({mesh}), p, v)).norm(), 1e-9);
    int inside = 1;
    EXPECT_EQ(forceAt(sceneWith({open}), p, v, &inside), Vector3::Zero());
    EXPECT_EQ(inside, 0);
  }
}

TEST(Zones, AddUpWhereTheyOverlap) {
  const Zone a = boxZone(Zone::Kind::viscous);
  const Zone b = boxZone(Zone::Kind::spring);
  int inside = 0;
  const Vector3 p(0.01, 0.02, 0.03), v(0.4, 0.5, 0.6);
  const Vector3 both = forceAt(sceneWith({a, b}), p, v, &inside);
  EXPECT_LT((both - forceAt(sceneWith({a}), p, v) - forceAt(sceneWith({b}), p, v)).norm(), 1e-12);
  EXPECT_EQ(inside, 2);
}

TEST(Zones, TakeHoldContinuouslyAcrossTheirBorders) {
  RandomShapes random(1);
  for (int run = 0; run < 200; ++run) {
    Zone zone = boxZone(run % 2 == 0 ? Zone::Kind::viscous : Zone::Kind::spring);
    zone.shape = run % 5 == 4 ? random.skewedBox() : random.shape(static_cast<Shape::Kind>(run % 5), 0.3);
    zone.anchor = random.vector(0.3);
    const HapticScene scene = sceneWith({zone});
    const Vector3 v = random.direction();
    const double step = 1e-5;
    const Vector3 way = random.direction();
    const Vector3 start = random.onSurface(zone.shape) - 0.02 * way;
    Vector3 last = forceAt(scene, start, v);
    for (int i = 1; i < 4000; ++i) {
      const Vector3 p = start + i * step * way;
      const Vector3 force = forceAt(scene, p, v);
      // Slope: the full force (below 150 N/m * 2 m, or 15 N) over the ball's diameter, and the spring itself.
      const double full = zone.kind == Zone::Kind::viscous ? 15 : 150 * (zone.anchor - p).norm();
      EXPECT_LE((force - last).norm(), 1.01 * step * (full / 0.02 + 150));
      last = force;
    }
  }
}

TEST(Zones, TurnWithTheScene) {
  RandomShapes random(2);
  const HapticScene scene = sceneWith({boxZone(Zone::Kind::viscous), boxZone(Zone::Kind::spring)});
  for (int i = 0; i < 500; ++i) {
    const Matrix3 R = random.rotation();
    const Vector3 t = random.vector(1), p = random.vector(0.12), v = random.vector(1);
    EXPECT_LT((R * forceAt(scene, p, v) - forceAt(moved(scene, R, t), R * p + t, R * v)).norm(), 1e-9);
  }
}

TEST(Zones, AreNotFeltOutside) {
  int inside = 1;
  EXPECT_EQ(forceAt(sceneWith({boxZone(Zone::Kind::spring)}), {0.1101, 0, 0}, {1, 1, 1}, &inside), Vector3::Zero());
  EXPECT_EQ(inside, 0);
}

}  // namespace
}  // namespace haptiv
