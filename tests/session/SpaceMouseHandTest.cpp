#include "app/session/hands/SpaceMouseHand.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "device/safety/SafetySignals.h"

namespace haptiv {
namespace {

using Mode = SpaceMouseHand::Mode;
constexpr std::int64_t kStep = 10'000'000;  // [ns]

/// A hand at a SpaceMouse, and a ball that goes where the hand wants it, or is held where it is.
class SpaceMouseHandTest : public ::testing::Test {
 protected:
  SpaceMouseHand::Wish run(double seconds) {
    SpaceMouseHand::Wish wish;
    for (int i = 0; i < std::lround(seconds * 1e9 / kStep); ++i) {
      now_ += kStep;
      if (speaks_) state_.time = now_;
      wish = hand_.follow(state_, now_, ball_, heading_);
      if (wish.place && !walled_) ball_ = {*wish.place, wish.rotation};
    }
    return wish;
  }
  void press(std::uint32_t buttons) { state_.buttons = buttons; }
  void push(std::size_t axis, std::int16_t counts) { state_.axes[axis] = counts; }

  SpaceMouseHand hand_;
  SpaceMouseState state_{true};
  Pose ball_{Vector3(0.1, 0.2, 0.3), Matrix3::Identity()};
  double heading_ = 0;
  bool walled_ = false, speaks_ = true;
  std::int64_t now_ = 1'000'000'000'000;
};

TEST_F(SpaceMouseHandTest, HoldsTheBallWhileButtonOneIsHeld) {
  EXPECT_FALSE(run(0.1).place);
  press(SpaceMouseHand::kHold);
  const auto wish = run(0.01);
  ASSERT_TRUE(wish.place);
  EXPECT_EQ(*wish.place, Vector3(0.1, 0.2, 0.3)) << "no jump when it takes hold";
  press(0);
  EXPECT_FALSE(run(0.01).place);
}

TEST_F(SpaceMouseHandTest, ButtonTwoIsTheReset) {
  press(SpaceMouseHand::kReset);
  EXPECT_EQ(run(0.01).inputs, kInputReset);
  press(0);
  EXPECT_EQ(run(0.01).inputs, 0);
}

TEST_F(SpaceMouseHandTest, ACapAtRestMovesNothingHoweverLong) {
  press(SpaceMouseHand::kHold);
  for (std::size_t axis = 0; axis < 6; ++axis) push(axis, axis % 2 == 0 ? 20 : -20);  // within the dead band
  const auto first = run(0.01), later = run(600);
  ASSERT_TRUE(first.place && later.place);
  EXPECT_EQ(*first.place, *later.place);
  EXPECT_EQ(first.rotation, later.rotation);
}

TEST_F(SpaceMouseHandTest, MovesRightAwayAndUpAsFastAsItIsPushed) {
  press(SpaceMouseHand::kHold);
  run(0.01);
  const Vector3 way[] = {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};  // of the cap's right, towards the user, down
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int sign : {1, -1}) {
      const Vector3 before = ball_.position;
      push(axis, static_cast<std::int16_t>(sign * 350));
      run(0.1);
      push(axis, 0);
      EXPECT_LT((ball_.position - before - sign * 0.1 * SpaceMouseHand::kSpeed * way[axis]).norm(), 1e-12) << axis;
    }
  }
}

TEST_F(SpaceMouseHandTest, HasNoStepAtTheDeadBandsEdgeAndNoMoreThanAllTheWay) {
  press(SpaceMouseHand::kHold);
  run(0.01);
  const auto speed = [&](std::int16_t counts) {
    const double before = ball_.position.x();
    push(0, counts);
    run(0.1);
    return (ball_.position.x() - before) / 0.1;
  };
  EXPECT_EQ(speed(20), 0);
  EXPECT_NEAR(speed(21), SpaceMouseHand::kSpeed / 330, 1e-9);
  EXPECT_NEAR(speed(185), SpaceMouseHand::kSpeed / 2, 1e-9);
  EXPECT_NEAR(speed(350), SpaceMouseHand::kSpeed, 1e-9);
  EXPECT_NEAR(speed(32767), SpaceMouseHand::kSpeed, 1e-9);
  EXPECT_NEAR(speed(-32768), -SpaceMouseHand::kSpeed, 1e-9);
}

TEST_F(SpaceMouseHandTest, GoesWhereTheUserLooks) {
  heading_ = std::numbers::pi / 2;  // along -x
  press(SpaceMouseHand::kHold);
  run(0.01);
  const Vector3 before = ball_.position;
  push(1, -350);  // away
  run(0.1);
  EXPECT_LT((ball_.position - before - Vector3(-0.1 * SpaceMouseHand::kSpeed, 0, 0)).norm(), 1e-12);
}

TEST_F(SpaceMouseHandTest, TurnsTheHandleAboutTheAxisThatTheCapIsTurnedAbout) {
  press(SpaceMouseHand::kHold);
  run(0.01);
  push(5, -350);  // against the cap's own z, which points down: to the left about the scene's
  run(0.5);
  const Eigen::AngleAxisd turn(ball_.rotation);
  EXPECT_NEAR(turn.angle(), 0.5 * SpaceMouseHand::kTurningSpeed, 1e-9);
  EXPECT_LT((turn.axis() - Vector3::UnitZ()).norm(), 1e-9);
}

TEST_F(SpaceMouseHandTest, PushesNoHarderTheLongerAWallHoldsTheBall) {
  press(SpaceMouseHand::kHold);
  run(0.01);
  walled_ = true;
  push(0, 350);
  const auto wish = run(60);
  EXPECT_NEAR((*wish.place - ball_.position).norm(), SpaceMouseHand::kLeash, 1e-12);
}

TEST_F(SpaceMouseHandTest, ByPositionGoesBackWhenTheCapDoes) {
  hand_ = SpaceMouseHand(Mode::position);
  press(SpaceMouseHand::kHold);
  const Vector3 before = *run(0.01).place;
  push(2, -350);
  push(3, 350);
  auto wish = run(1);
  EXPECT_LT((*wish.place - before - SpaceMouseHand::kReach * Vector3::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(Eigen::AngleAxisd(wish.rotation).angle(), SpaceMouseHand::kTurn, 1e-9);
  push(2, 0);
  push(3, 0);
  wish = run(0.01);
  EXPECT_EQ(*wish.place, before);
  EXPECT_EQ(wish.rotation, Matrix3(Matrix3::Identity()));
}

TEST_F(SpaceMouseHandTest, LetsGoWhenItIsUnplugged) {
  press(SpaceMouseHand::kHold | SpaceMouseHand::kReset);
  push(0, 350);
  EXPECT_TRUE(run(0.1).place);
  state_ = {};
  const auto wish = run(0.01);
  EXPECT_FALSE(wish.place);
  EXPECT_EQ(wish.inputs, 0);
}

TEST_F(SpaceMouseHandTest, LetsGoWhenACapThatStoodAsideFallsSilent) {
  press(SpaceMouseHand::kHold);
  push(0, 350);
  run(0.1);
  speaks_ = false;
  EXPECT_TRUE(run(0.2).place);
  EXPECT_FALSE(run(0.1).place);
  push(0, 0);  // at rest it may be silent as long as it likes
  EXPECT_TRUE(run(10).place);
}

TEST_F(SpaceMouseHandTest, AProgramThatWasAwayDoesNotCatchUp) {
  press(SpaceMouseHand::kHold);
  run(0.01);
  push(0, 350);
  const double before = ball_.position.x();
  now_ += 3'000'000'000;
  run(0.01);
  EXPECT_LE(ball_.position.x() - before, 0.1 * SpaceMouseHand::kSpeed + 1e-12);
}

}  // namespace
}  // namespace haptiv
