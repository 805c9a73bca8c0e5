#include <gtest/gtest.h>

#include <algorithm>

#include "haptics/laws/IfThenRenderer.h"
#include "haptics/laws/Zones.h"
#include "tests/haptics/RandomShapes.h"
#include "tests/haptics/meshes/SampleMeshes.h"

namespace haptiv {
namespace {

using testing::boxSoup;
using testing::kRest;
using testing::meshWall;
using testing::moved;
using testing::RandomShapes;

constexpr double kRadius = 0.01;    // of the ball [m]
constexpr double kDeepest = 0.007;  // pressed deeper than its radius, an edge lets go of the ball [m]
constexpr double kStep = 2e-5;      // of the way [m]
constexpr double kStiffest = 2000;  // [N/m]
constexpr double kSpring = 150;     // of a zone [N/m]
constexpr double kMedium = 15;      // of a zone [N s/m]
const Vector3 kSpeed(0.3, 0.4, 0);  // at which zones are felt [m/s]

/// A wall of each exact kind and a mesh, some into each other, as thin as 5 mm, and a zone of each kind over them.
HapticScene randomScene(RandomShapes& random, int walls) {
  HapticScene scene;
  scene.version = 1;
  for (int i = 0; i < walls; ++i) {
    const int kind = static_cast<int>(random.between(0, 4.999));
    Wall& wall = scene.walls.emplace_back();
    if (kind < 4) {
      wall.shape = random.shape(static_cast<Shape::Kind>(kind), 0.06);
    } else {
      wall = meshWall(moved(boxSoup(kRest, 0.04 * Matrix3::Identity(), 2), random.rotation(), random.vector(0.06)));
    }
    wall.id = static_cast<ShapeId>(i + 1);
    wall.surface.stiffness = random.between(500, kStiffest);
  }
  for (const Zone::Kind kind : {Zone::Kind::viscous, Zone::Kind::spring, Zone::Kind::rubberBand}) {
    Zone& zone = scene.zones.emplace_back();
    zone.kind = kind;
    zone.shape = random.shape(static_cast<Shape::Kind>(random.between(0, 3.999)), 0.08);
    zone.anchor = zone.shape.centre = random.vector(0.03);
    zone.stiffness = kSpring;
    zone.damping = kMedium;
  }
  computeBounds(scene);
  return scene;
}

/// A ball that wanders about the scene and presses on, over faces, edges and corners, from wall to wall.
class Wanderer {
 public:
  Wanderer(RandomShapes& random, const Vector3& goal)
      : random_(random), goal_(goal), p_(0.2 * random.direction()), way_((goal - p_).normalized()) {}

  /// @param held  where the walls let the ball be
  Vector3 step(const Vector3& held) {
    way_ = (way_ + 0.02 * random_.vector(1) - 0.005 * (p_ - goal_).normalized()).normalized();
    if ((p_ - held).norm() > kDeepest) way_ = (held - p_).normalized();
    return p_ += kStep * way_;
  }
  const Vector3& position() const { return p_; }

 private:
  RandomShapes& random_;
  Vector3 goal_, p_, way_;
};

/// At an edge the proxy goes r / (r - d) times as far as the ball, 3.3 here; where walls meet, it goes on from one to
/// the next. Of 22 million such steps, six in one corner of two walls were steeper, up to 6.3 times the stiffest wall.
TEST(RandomPaths, ChangeTheForceOfWallsContinuouslyOverFacesEdgesAndCorners) {
  std::size_t touching = 0;
  for (unsigned run = 0; run < 40; ++run) {
    RandomShapes random(run);
    const HapticScene scene = randomScene(random, 1 + static_cast<int>(run % 4));
    Wanderer ball(random, scene.walls.front().shape.centre);
    ContactSet contacts;
    Vector3 last = renderWalls(scene, {ball.position(), kRest, kRadius}, contacts);
    for (int tick = 0; tick < 15000; ++tick) {
      const Vector3 force = renderWalls(scene, {ball.step(contacts.surfacePosition), kRest, kRadius}, contacts);
      ASSERT_LT((force - last).norm(), 4.5 * kStiffest * kStep) << run << " " << tick;
      touching += contacts.count > 0 ? 1 : 0;
      last = force;
    }
  }
  EXPECT_GT(touching, 40 * 15000 / 4);
}

/// A zone takes hold over the ball's diameter; a spring has its own slope besides.
TEST(RandomPaths, ChangeTheForceOfZonesContinuouslyAcrossTheirBorders) {
  int most = 0;
  for (unsigned run = 0; run < 40; ++run) {
    RandomShapes random(run);
    const HapticScene scene = randomScene(random, 0);
    Wanderer ball(random, kRest);
    int inside = 0;
    Vector3 last = renderZones(scene, {ball.position(), kSpeed, kRadius}, inside);
    for (int tick = 0; tick < 15000; ++tick) {
      const Vector3 p = ball.step(ball.position());
      const Vector3 force = renderZones(scene, {p, kSpeed, kRadius}, inside);
      double slope = 0;
      for (const Zone& zone : scene.zones) {
        const bool isViscous = zone.kind == Zone::Kind::viscous;
        const double full = isViscous ? kMedium * kSpeed.norm() : kSpring * (zone.anchor - p).norm();
        slope += full / (2 * kRadius) + (isViscous ? 0 : kSpring);
      }
      ASSERT_LE((force - last).norm(), 1.01 * slope * kStep) << run << " " << tick;
      most = std::max(most, inside);
      last = force;
    }
  }
  EXPECT_EQ(most, 3);
}

}  // namespace
}  // namespace haptiv
