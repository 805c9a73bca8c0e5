#include "app/view/drawn/HapticOverlay.h"

#include <Inventor/SbViewportRegion.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/nodes/SoSphere.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/view/drawn/ForceArrow.h"
#include "device/kinematics/Vishard10.h"

namespace haptiv {
namespace {

constexpr double kRadius = 0.012;
constexpr double kFloatAccuracy =
    1e-5;  // Coin's floats, and spheres that are polygons when drawn but exact in their box

constexpr double kPolygons = 0.003;  // [m] at a speed of 1: drawn as a polyhedron, a sphere is smaller in places

class HapticOverlayTest : public testing::Test {
 protected:
  HapticOverlayTest() {
    scene_.tool.radius = kRadius;
    scene_.tool.home = {0.1, -0.05, 0.03};
    overlay_.setUp(scene_, description_);
  }

  SbBox3f box() const {
    SoGetBoundingBoxAction bounds(SbViewportRegion(640, 480));
    bounds.apply(overlay_.root());
    return bounds.getBoundingBox();
  }

  /// How far in this direction from `centre` the spheres go that are drawn.
  double reach(const Vector3& centre, const Vector3& direction) const {
    struct {
      Vector3 centre, direction;
      double farthest = 0;
    } search{centre, direction};
    SoCallbackAction action;
    action.addTriangleCallback(
        SoSphere::getClassTypeId(),
        [](void* data, SoCallbackAction* at, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b,
           const SoPrimitiveVertex* c) {
          auto& found = *static_cast<decltype(search)*>(data);
          for (const SoPrimitiveVertex* vertex : {a, b, c}) {
            SbVec3f p_W;
            at->getModelMatrix().multVecMatrix(vertex->getPoint(), p_W);
            const Vector3 from = Vector3(p_W[0], p_W[1], p_W[2]) - found.centre;
            found.farthest = std::max(found.farthest, from.dot(found.direction));
          }
        },
        &search);
    action.apply(overlay_.root());
    return search.farthest;
  }

  TickRecord recordAt(const Vector3& position) const {
    TickRecord record;
    record.position = position;
    record.jointAngles = Vishard10(description_.links).inverse(position, description_.homeAngles);
    return record;
  }

  HapticScene scene_;
  DeviceDescription description_;
  HapticOverlay overlay_;
};

TEST_F(HapticOverlayTest, RestsAtTheToolsHomeWithoutAForce) {
  overlay_.setArmVisible(false);
  const SbBox3f ball = box();
  EXPECT_EQ(overlay_.ballPosition(), scene_.tool.home);
  EXPECT_NEAR(overlay_.ballRadius(), kRadius, kFloatAccuracy);
  EXPECT_NEAR(ball.getCenter()[0], 0.1, kFloatAccuracy);
  EXPECT_NEAR(ball.getCenter()[1], -0.05, kFloatAccuracy);
  EXPECT_NEAR(ball.getCenter()[2], 0.03, kFloatAccuracy);
  EXPECT_NEAR(ball.getMax()[0] - ball.getMin()[0], 2 * kRadius, kFloatAccuracy);
}

TEST_F(HapticOverlayTest, ShowsTheBallWhereTheRecordHasIt) {
  overlay_.setArmVisible(false);
  overlay_.show(recordAt({-0.2, 0.15, 0.04}));
  const SbVec3f centre = box().getCenter();
  EXPECT_NEAR(centre[0], -0.2, kFloatAccuracy);
  EXPECT_NEAR(centre[1], 0.15, kFloatAccuracy);
  EXPECT_NEAR(centre[2], 0.04, kFloatAccuracy);
}

TEST_F(HapticOverlayTest, PutsTheArmsEndAtTheBall) {
  overlay_.show(recordAt({0.1, 0.1, 0.02}));
  const SbBox3f withArm = box();
  EXPECT_GT(withArm.getMax()[2], 0.7F) << "the SCARA plane is 0.71 m above joint 6";
  EXPECT_TRUE(withArm.intersect(SbVec3f(0.1F, 0.1F, 0.02F)));
  overlay_.setArmVisible(false);
  EXPECT_LT(box().getMax()[2], 0.1F);
}

TEST_F(HapticOverlayTest, DrawsTheForceFromTheBallsSurfaceAlongTheForce) {
  overlay_.setArmVisible(false);
  TickRecord record = recordAt({0, 0, 0});
  record.environmentForce = {0, 12, 0};
  overlay_.show(record);
  const SbBox3f drawn = box();
  EXPECT_NEAR(drawn.getMax()[1], kRadius + 12 * ForceArrow::kMetresPerNewton, kFloatAccuracy);
  EXPECT_NEAR(drawn.getMin()[1], -kRadius, kFloatAccuracy);
  EXPECT_NEAR(drawn.getMax()[0], kRadius, kFloatAccuracy) << "the arrow is slimmer than the ball";
}

TEST_F(HapticOverlayTest, DrawsTheHandsForceToo) {
  overlay_.setArmVisible(false);
  TickRecord record = recordAt({0, 0, 0});
  record.environmentForce = {0, 12, 0};
  record.handForce = {0, -10, 0};
  overlay_.show(record);
  EXPECT_NEAR(box().getMin()[1], -kRadius - 10 * ForceArrow::kMetresPerNewton, kFloatAccuracy);
}

TEST_F(HapticOverlayTest, DrawsNoArrowLongerThanTheLongest) {
  overlay_.setArmVisible(false);
  TickRecord record = recordAt({0, 0, 0});
  record.environmentForce = {500, 0, 0};
  overlay_.show(record);
  EXPECT_NEAR(box().getMax()[0], kRadius + ForceArrow::kLongest, kFloatAccuracy);
}

TEST_F(HapticOverlayTest, HidesForcesThatAreNone) {
  overlay_.setArmVisible(false);
  TickRecord record = recordAt({0, 0, 0});
  record.environmentForce = {0.9 * ForceArrow::kWeakestShown, 0, 0};
  overlay_.show(record);
  EXPECT_NEAR(box().getMax()[0], kRadius, kFloatAccuracy);
}

TEST_F(HapticOverlayTest, TouchesNothingWhenTheRecordIsTheSame) {
  TickRecord record = recordAt({0.05, 0.1, 0.02});
  record.environmentForce = {1, 2, 3};
  record.handForce = {-1, -2, 0};
  overlay_.show(record);
  const auto before = overlay_.root()->getNodeId();  // Coin gives a new one to each node above a changed field
  record.tick += 1;
  overlay_.show(record);
  EXPECT_EQ(overlay_.root()->getNodeId(), before);
  record.environmentForce.x() += 0.5;
  overlay_.show(record);
  EXPECT_NE(overlay_.root()->getNodeId(), before);
}

TEST_F(HapticOverlayTest, EllipsoidsAreHiddenUntilAskedForAndReachAsFarAsTheToolIsFast) {
  overlay_.setArmVisible(false);
  const TickRecord record = recordAt({0.1, 0, 0});
  overlay_.show(record);
  EXPECT_NEAR(box().getMax()[0], 0.1 + kRadius, kFloatAccuracy);
  const Jacobian J = ArmKinematics(description_).jacobian(record.jointAngles);
  overlay_.setEllipsoidVisible(Manipulability::translational, true);
  const Vector3 direction = Vector3(1, -2, 0.5).normalized();
  const double speed = (J.topRows<3>().transpose() * direction).norm();  // largest along it, at rates of norm 1 rad/s
  EXPECT_NEAR(reach(record.position, direction), DexterityFigure::kMetresPerSpeed * speed, kPolygons * speed);
  overlay_.setEllipsoidVisible(Manipulability::translational, false);
  overlay_.setEllipsoidVisible(Manipulability::rotational, true);
  const double turning = (J.bottomRows<3>().transpose() * direction).norm();
  EXPECT_NEAR(reach(record.position, direction), DexterityFigure::kMetresPerTurning * turning, kPolygons * turning);
}

TEST_F(HapticOverlayTest, FlatEllipsoidsAreDrawnToo) {
  overlay_.setArmVisible(false);
  TickRecord record = recordAt({0, 0, 0});
  record.jointAngles.setZero();  // stretched: the tool cannot move along x
  overlay_.setEllipsoidVisible(Manipulability::translational, true);
  overlay_.setEllipsoidVisible(Manipulability::rotational, true);
  overlay_.show(record);
  const SbBox3f drawn = box();
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(std::isfinite(drawn.getMax()[i])) << i;
    EXPECT_GT(drawn.getMax()[i] - drawn.getMin()[i], 0.01F) << i;
  }
}

TEST_F(HapticOverlayTest, StandsWhereTheSceneStandsTheDevice) {
  scene_.device.position = {1, 2, 3};
  scene_.device.scale = 2;
  scene_.tool.home = {1.1, 2.1, 3};
  overlay_.setUp(scene_, description_);
  const SbBox3f drawn = box();
  EXPECT_GT(drawn.getMax()[2], 3 + 2 * description_.links.scaraHeight);
  EXPECT_TRUE(drawn.intersect(SbVec3f(1, 2, 3 + 2 * static_cast<float>(description_.links.scaraHeight))));
}

}  // namespace
}  // namespace haptiv
