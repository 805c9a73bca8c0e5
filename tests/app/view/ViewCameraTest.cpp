#include "app/view/ViewCamera.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "app/view/HandGrip.h"

namespace haptiv {
namespace {

constexpr QSize kPicture(1280, 720);
const SbBox3f kBox({-0.3F, -0.2F, 0}, {0.3F, 0.2F, 0.06F});
constexpr double kPixel = 0.05;  // Coin projects in floats

QPointF pixelOf(const ViewCamera& camera, double x, double y, double z) {
  return camera.toPixel({x, y, z}, kPicture);
}

double apart(const QPointF& a, const QPointF& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

TEST(ViewCamera, ShowsXToTheRightAndYUpFromAbove) {
  ViewCamera camera;
  camera.setFromAbove(true);
  camera.fit({kBox}, 16.0 / 9);
  const QPointF middle = pixelOf(camera, 0, 0, 0);
  const QPointF right = pixelOf(camera, 0.1, 0, 0);
  const QPointF up = pixelOf(camera, 0, 0.1, 0);
  EXPECT_GT(right.x(), middle.x() + 50);
  EXPECT_NEAR(right.y(), middle.y(), kPixel);
  EXPECT_LT(up.y(), middle.y() - 50);
  EXPECT_NEAR(up.x(), middle.x(), kPixel);
}

TEST(ViewCamera, FitsTheBoxIntoThePicture) {
  for (const QSize picture : {QSize(1280, 720), QSize(500, 900)}) {
    for (bool fromAbove : {true, false}) {
      ViewCamera camera;
      camera.setFromAbove(fromAbove);
      camera.fit({kBox}, static_cast<double>(picture.width()) / picture.height());
      double used = 0;
      for (int i = 0; i < 8; ++i) {
        const QPointF p = camera.toPixel({i & 1 ? 0.3 : -0.3, i & 2 ? 0.2 : -0.2, i & 4 ? 0.06 : 0.0}, picture) -
                          QPointF(picture.width() / 2.0, picture.height() / 2.0);
        used = std::max({used, 2 * std::abs(p.x()) / picture.width(), 2 * std::abs(p.y()) / picture.height()});
      }
      EXPECT_LT(used, 1);
      EXPECT_GT(used, 0.85);
    }
  }
}

TEST(ViewCamera, KeepsLookingAtTheSamePlaceWhenThePlanComesAndGoes) {
  ViewCamera camera;
  camera.fit({kBox}, 16.0 / 9);
  camera.pan({600, 300}, {700, 350}, kPicture);
  const Vector3 before = camera.onFocalPlane({640, 360}, kPicture);
  camera.setFromAbove(true);
  EXPECT_LT(apart(camera.toPixel(before, kPicture), {640, 360}), kPixel);
  camera.setFromAbove(false);
  EXPECT_LT(apart(camera.toPixel(before, kPicture), {640, 360}), kPixel);
}

TEST(ViewCamera, ZoomsTowardsAPlaceThatStaysUnderTheMouse) {
  for (bool fromAbove : {true, false}) {
    ViewCamera camera;
    camera.setFromAbove(fromAbove);
    camera.fit({kBox}, 16.0 / 9);
    const Vector3 place(0.2, -0.1, 0.06);
    const QPointF before = camera.toPixel(place, kPicture);
    const double size = camera.metresPerPixel(place, kPicture);
    camera.zoom(2, place);
    EXPECT_LT(apart(camera.toPixel(place, kPicture), before), kPixel);
    EXPECT_NEAR(camera.metresPerPixel(place, kPicture), size / 2, size * 1e-3);
  }
}

TEST(ViewCamera, PansWhatWasUnderTheMouseAlong) {
  ViewCamera camera;
  camera.fit({kBox}, 16.0 / 9);
  const Vector3 place = camera.onFocalPlane({500, 200}, kPicture);
  camera.pan({500, 200}, {620, 410}, kPicture);
  EXPECT_LT(apart(camera.toPixel(place, kPicture), {620, 410}), kPixel);
}

TEST(ViewCamera, OrbitsAboutThePlaceLookedAtAndLeavesThePlanWithoutAJump) {
  ViewCamera camera;
  camera.setFromAbove(true);
  camera.fit({kBox}, 16.0 / 9);
  camera.orbit({0, 0}, kPicture);
  EXPECT_FALSE(camera.isFromAbove());
  const QPointF middle = pixelOf(camera, 0, 0, 0.03);
  EXPECT_LT(apart(middle, {640, 360}), kPixel);
  EXPECT_GT(pixelOf(camera, 0.1, 0, 0.03).x(), middle.x() + 50);
  camera.orbit({200, -150}, kPicture);
  EXPECT_LT(apart(pixelOf(camera, 0, 0, 0.03), {640, 360}), kPixel);
}

TEST(ViewCamera, MeetsWithItsRaysWhatItProjects) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-0.3, 0.3);
  ViewCamera camera;
  camera.fit({kBox}, 16.0 / 9);
  for (int i = 0; i < 200; ++i) {
    camera.orbit({500 * unit(random), 100 * unit(random)}, kPicture);
    const Vector3 place(unit(random), unit(random), unit(random));
    const ViewRay ray = camera.ray(camera.toPixel(place, kPicture), kPicture);
    const Vector3 off = (place - ray.origin).cross(ray.direction);
    EXPECT_LT(off.norm(), 1e-4) << "a tenth of a pixel";
  }
}

TEST(HandGrip, StaysInTheHorizontalPlaneOfTheBallAndDoesNotJump) {
  ViewCamera camera;
  camera.fit({kBox}, 16.0 / 9);
  const Vector3 ball(0.05, 0.02, 0.04);
  HandGrip grip(camera);
  const QPointF beside = camera.toPixel(ball, kPicture) + QPointF(9, -4);
  ASSERT_TRUE(grip.reaches(beside, kPicture, ball, 0.01));
  grip.take(beside, ball);
  EXPECT_LT((grip.drag(beside, kPicture, false) - ball).norm(), 1e-6);
  const Vector3 there = grip.drag(beside + QPointF(120, 60), kPicture, false);
  EXPECT_NEAR(there.z(), ball.z(), 1e-6);
  EXPECT_GT((there - ball).head<2>().norm(), 0.05);
  const QPointF seen = camera.toPixel(there, kPicture) - camera.toPixel(ball, kPicture);
  EXPECT_NEAR(seen.x(), 120, 6) << "the ball goes with the mouse, but for the perspective across the grip's 9 pixels";
  EXPECT_NEAR(seen.y(), 60, 6);
}

TEST(HandGrip, MovesStraightUpAndDownWithShift) {
  for (bool fromAbove : {true, false}) {
    ViewCamera camera;
    camera.setFromAbove(fromAbove);
    camera.fit({kBox}, 16.0 / 9);
    const Vector3 ball(0.05, 0.02, 0.04);
    HandGrip grip(camera);
    const QPointF at = camera.toPixel(ball, kPicture);
    grip.take(at, ball);
    const Vector3 aside = grip.drag(at + QPointF(80, 0), kPicture, false);
    EXPECT_EQ(grip.drag(at + QPointF(80, 0), kPicture, true), aside) << "pressing Shift alone moves nothing";
    const Vector3 up = grip.drag(at + QPointF(80, -50), kPicture, true);
    EXPECT_EQ(up.head<2>(), aside.head<2>());
    EXPECT_GT(up.z(), aside.z() + 0.01);
  }
}

TEST(HandGrip, FacesTheCameraWhenTheViewIsFlat) {
  ViewCamera camera;
  camera.fit({kBox}, 16.0 / 9);
  camera.orbit({0, -170}, kPicture);  // from 48 degrees down to about 5
  const Vector3 ball(0, 0, 0.03);
  HandGrip grip(camera);
  const QPointF at = camera.toPixel(ball, kPicture);
  grip.take(at, ball);
  const Vector3 up = grip.drag(at - QPointF(0, 60), kPicture, false);
  EXPECT_GT(up.z(), ball.z() + 0.02);
  EXPECT_NEAR((up - ball).dot(camera.direction()), 0, 1e-6);
}

TEST(HandGrip, DoesNotReachFarFromTheBall) {
  ViewCamera camera;
  camera.setFromAbove(true);
  camera.fit({kBox}, 16.0 / 9);
  const Vector3 ball(0, 0, 0.03);
  const double radius = 0.01;
  const double edge = radius / camera.metresPerPixel(ball, kPicture);
  HandGrip grip(camera);
  const QPointF at = camera.toPixel(ball, kPicture);
  EXPECT_TRUE(grip.reaches(at + QPointF(edge + 11, 0), kPicture, ball, radius));
  EXPECT_FALSE(grip.reaches(at + QPointF(edge + 13, 0), kPicture, ball, radius));
}

TEST(ViewCamera, LooksLikeACameraOfTheScene) {
  ViewCamera camera;
  const NodeRef<SoPerspectiveCamera> own(new SoPerspectiveCamera);
  own->position.setValue(1, -2, 1.5);
  own->pointAt(SbVec3f(0.3F, 0.1F, 0), SbVec3f(0, 0, 1));
  own->focalDistance = (own->position.getValue() - SbVec3f(0.3F, 0.1F, 0)).length();
  camera.setFromAbove(true);
  camera.lookLike(*own.get());
  EXPECT_FALSE(camera.isFromAbove());
  EXPECT_LT(apart(pixelOf(camera, 0.3, 0.1, 0), QPointF(640, 360)), kPixel);
  EXPECT_NEAR(camera.ray(QPointF(640, 360), kPicture).direction.dot(Vector3(-0.7, 2.1, -1.5).normalized()), 1, 1e-6);
  own->orientation.setValue(SbRotation::identity());  // straight down, y up in the picture
  camera.lookLike(*own.get());
  EXPECT_LT(pixelOf(camera, 1, -1.9, 0).y(), pixelOf(camera, 1, -2, 0).y());
  EXPECT_NEAR(pixelOf(camera, 1, -1.9, 0).x(), pixelOf(camera, 1, -2, 0).x(), kPixel);
}

}  // namespace
}  // namespace haptiv
