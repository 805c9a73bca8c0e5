#include "haptics/tick/HapticTick.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/haptics/tick/HapticTickFixture.h"

namespace haptiv {
namespace {

using testing::HapticTickTest;
using testing::IdealArm;
using testing::kRate;
using testing::readingOf;

TEST_F(HapticTickTest, StartsAtRestWhereTheDeviceIs) {
  scene.resolution = ResolutionChoice{Strategy::nonopt, Solution::full};  // no self-motion
  TickState state = ready();
  const TickRecord record = tick(scene, readingOf(description, start), state);
  EXPECT_EQ(record.faults, kNoFault);
  EXPECT_TRUE(record.command.enabled);
  EXPECT_LT(record.command.jointRates.norm(), 1e-9);
  EXPECT_EQ(record.position, record.desiredPosition);
  EXPECT_EQ(record.environmentForce, Vector3::Zero());
  EXPECT_LT((record.jointAngles - start).cwiseAbs().maxCoeff(), 1e-4);  // one encoder count is 1e-5 rad
}

TEST_F(HapticTickTest, GivesTheSameBitsForTheSameInputs) {
  const std::vector<TickRecord> a = run(scene, {20, 3, -2}, 1000);
  const std::vector<TickRecord> b = run(scene, {20, 3, -2}, 1000);
  ASSERT_EQ(a.size(), 1000u);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].reading.encoderCounts, b[i].reading.encoderCounts);
    EXPECT_EQ(a[i].command.jointRates, b[i].command.jointRates);
    EXPECT_EQ(a[i].environmentForce, b[i].environmentForce);
    EXPECT_EQ(a[i].desiredPosition, b[i].desiredPosition);
    EXPECT_EQ(a[i].time, static_cast<std::int64_t>(i) * 1'000'000);
  }
}

TEST_F(HapticTickTest, CanBeRepeatedFromTheReadingsAlone) {
  const std::vector<TickRecord> recorded = run(scene, {20, 3, -2}, 500);
  TickState state;
  for (const TickRecord& before : recorded) {
    const TickRecord again = tick(scene, before.reading, state);
    EXPECT_EQ(again.command.jointRates, before.command.jointRates);
    EXPECT_EQ(again.position, before.position);
    EXPECT_EQ(again.penetration, before.penetration);
  }
}

TEST_F(HapticTickTest, IsNotDisturbedByAnotherArmBesideIt) {
  const std::vector<TickRecord> left = run(scene, {20, 3, -2}, 500), right = run(scene, {-4, 8, 1}, 500);
  const HapticTick another(description, 1 / kRate);
  TickState ofLeft, ofRight;
  for (std::size_t i = 0; i < left.size(); ++i) {  // in turns
    const TickRecord l = tick(scene, left[i].reading, ofLeft), r = another(scene, right[i].reading, ofRight);
    EXPECT_EQ(l.command.jointRates, left[i].command.jointRates);
    EXPECT_EQ(r.command.jointRates, right[i].command.jointRates);
    EXPECT_EQ(l.environmentForce, left[i].environmentForce);
    EXPECT_EQ(r.environmentForce, right[i].environmentForce);
  }
}

TEST_F(HapticTickTest, HoldsTheOrientationWhileTheBallMoves) {
  const std::vector<TickRecord> records = run({}, {5, 4, -3}, 300);
  const Vishard10 arm(description.links);
  const Matrix3 held = arm.forward(records.front().jointAngles).rotation;
  EXPECT_GT((records.back().position - records.front().position).norm(), 0.05);
  const Matrix3 now = arm.forward(records.back().jointAngles).rotation;
  EXPECT_LT((now - held).norm(), 1e-3);  // drift correction leaves rate / gain * period
}

TEST_F(HapticTickTest, MovesTheArmToWhereTheAdmittanceIs) {
  const std::vector<TickRecord> records = run({}, {5, 4, -3}, 500);
  for (const TickRecord& record : records) {
    EXPECT_LT((record.position - record.desiredPosition).norm(), 2e-4);
  }
}

TEST_F(HapticTickTest, ReachesTheSpeedAtWhichFreeDampingBalancesTheHand) {
  // 1.5 N against 5 N s/m: 0.3 m/s after many time constants of m/b = 0.4 s would leave the workspace; b is raised.
  HapticScene free;
  free.tool.damping = 50;
  const std::vector<TickRecord> records = run(free, {5, 0, 0}, 1000);
  EXPECT_NEAR(records.back().desiredVelocity.x(), 0.1, 1e-3);
}

TEST_F(HapticTickTest, ScalesAndTurnsMotionByTheDevicesPlacement) {
  HapticScene placed;
  placed.device.position = {1, 2, 3};
  placed.device.scale = 2;
  placed.device.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // B's x is W's y
  const std::vector<TickRecord> records = run(placed, {5, 0, 0}, 300);
  const Vector3 p_BT = Vishard10(description.links).forward(records.back().jointAngles).position;
  const Vector3 expected = Vector3(1, 2, 3) + 2 * (placed.device.rotation * p_BT);
  EXPECT_LT((records.back().position - expected).norm(), 1e-9);
  EXPECT_NEAR(records.back().handForce.y(), 5, 0.05);
  EXPECT_GT(records.back().position.y(), records.front().position.y() + 0.05);
  EXPECT_LT((records.back().position - records.back().desiredPosition).norm(), 4e-4);
}

TEST_F(HapticTickTest, NeverAsksAJointForMoreThanItCan) {
  HapticScene light;
  light.tool.mass = 0.1;
  light.tool.damping = 0;
  const std::vector<TickRecord> records = run(light, {100, 50, 100}, 2000);
  for (const TickRecord& record : records) {
    EXPECT_TRUE((record.command.jointRates.cwiseAbs().array() <= description.drives.rateLimit.array()).all());
    EXPECT_TRUE(record.command.jointRates.allFinite());
  }
}

TEST_F(HapticTickTest, NeverStepsTheForceWhenTheSceneIsEditedInContact) {
  HapticScene stiffer = scene;
  stiffer.version = 2;
  stiffer.walls[0].surface.stiffness = 6000;
  HapticScene closer = scene;
  closer.version = 3;
  closer.walls[0].shape.centre.x() -= 0.05;  // the ball is now well inside
  computeBounds(closer);
  HapticScene empty;
  empty.version = 4;

  IdealArm arm(description, start, inTool({20, 0, 0}));
  arm.start(1 / kRate);
  TickState state;
  Vector3 last = Vector3::Zero(), lastVelocity = Vector3::Zero();
  Vector3 lastPosition = Vishard10(description.links).forward(start).position;
  for (int i = 0; i < 4000; ++i) {
    const HapticScene& now = i < 1000 ? scene : i < 2000 ? stiffer : i < 3000 ? closer : empty;
    const TickRecord record = tick(now, arm.read(), state);
    arm.write(record.command);
    ASSERT_EQ(record.faults, kNoFault);
    // 300 N at the most fade in over 100 ticks; beside it the wall's law along the ball's way.
    const double stiffness = 6000 * (record.desiredPosition - lastPosition).norm();
    const double damping = 20 * (record.desiredVelocity.norm() + lastVelocity.norm());
    EXPECT_LT((record.environmentForce - last).norm(), 300.0 / 100 + stiffness + damping) << "tick " << i;
    lastPosition = record.desiredPosition;
    lastVelocity = record.desiredVelocity;
    last = record.environmentForce;
  }
}

TEST_F(HapticTickTest, FeelsAnEditInFullAfterATenthOfASecond) {
  SceneFade fade;
  HapticScene edited = scene;
  edited.version = 2;
  const Vector3 before(1, 2, 3), after(-30, 0, 9);
  EXPECT_EQ(fade.apply(scene, before, 1e-3), Vector3::Zero());
  for (int i = 0; i < 101; ++i) fade.apply(scene, before, 1e-3);
  EXPECT_EQ(fade.apply(scene, before, 1e-3), before);
  EXPECT_LT((fade.apply(edited, after, 1e-3) - before).norm(), 1e-12);
  for (int i = 0; i < 49; ++i) fade.apply(edited, after, 1e-3);
  EXPECT_LT((fade.apply(edited, after, 1e-3) - (before + after) / 2).norm(), 1e-9);
  for (int i = 0; i < 51; ++i) fade.apply(edited, after, 1e-3);
  EXPECT_EQ(fade.apply(edited, after, 1e-3), after);
}

}  // namespace
}  // namespace haptiv
