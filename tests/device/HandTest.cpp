#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <vector>

#include "device/simulated/HumanHand.h"
#include "device/simulated/ScriptedHand.h"

namespace haptiv {
namespace {

const Vector3 kX = Vector3::UnitX();
constexpr double kSubstep = 0.25e-3;

TEST(HumanHand, PullsWithItsSpringOnceItHasSettled) {
  HumanHand hand{HandModel{}};
  Vector3 force;
  for (int i = 0; i < 4000; ++i) force = hand.pull({true, 0.05 * kX}, Vector3::Zero(), Vector3::Zero(), kSubstep);
  EXPECT_LT((force - 400 * 0.05 * kX).norm(), 1e-9);  // 1 s is 40 time constants
}

TEST(HumanHand, TakesHoldWithoutAJerkEvenOfAMovingHandle) {
  HumanHand hand{HandModel{}};
  const Vector3 force = hand.pull({true, Vector3(1, 1, 1)}, Vector3(0.2, 0, 0), Vector3(0, 0.5, 0), kSubstep);
  // What 0.25 ms of a 1.6 m wish and 0.5 m/s of speed can do: b w^2 d dt + b 2 w v dt.
  EXPECT_LT(force.norm(), 20 * (1600 * 1.7 + 80 * 0.5) * kSubstep);
}

TEST(HumanHand, MakesNoSpikesOfATargetThatMovesInSteps) {
  HumanHand hand{HandModel{}};
  Vector3 before = Vector3::Zero();
  for (int i = 0; i < 4000; ++i) {
    const Vector3 target = 0.01 * (i / 64) * kX;  // a mouse at 62 Hz
    const Vector3 force = hand.pull({true, target}, Vector3::Zero(), Vector3::Zero(), kSubstep);
    // Steps of 0.01 m change the force by b w^2 0.01 dt at once, and the spring adds k v dt.
    EXPECT_LT((force - before).norm(), 4 * 20 * 1600 * 0.01 * kSubstep + 400 * 1. * kSubstep);
    before = force;
  }
}

TEST(HumanHand, NeverPullsHarderThanItsPeak) {
  HumanHand hand{HandModel{}};
  double strongest = 0;
  for (int i = 0; i < 4000; ++i) {
    const double force = hand.pull({true, Vector3(3, -4, 5)}, Vector3::Zero(), Vector3::Zero(), kSubstep).norm();
    strongest = std::max(strongest, force);
  }
  EXPECT_NEAR(strongest, 170, 1e-9);
}

TEST(HumanHand, HasNoForceWhenItHasLetGoAndStartsAnew) {
  HumanHand hand{HandModel{}};
  for (int i = 0; i < 1000; ++i) hand.pull({true, kX}, Vector3::Zero(), Vector3::Zero(), kSubstep);
  EXPECT_EQ(hand.pull({false, kX}, Vector3::Zero(), Vector3::Zero(), kSubstep), Vector3::Zero());
  EXPECT_LT(hand.pull({true, kX}, Vector3::Zero(), Vector3::Zero(), kSubstep).norm(), 20 * 1600 * 1.1 * kSubstep);
}

TEST(HumanHand, LetsGoWhereItsTargetIsNoPlace) {
  HumanHand hand{HandModel{}};
  const Vector3 nowhere = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(hand.pull({true, nowhere}, Vector3::Zero(), Vector3::Zero(), kSubstep), Vector3::Zero());
}

TEST(ScriptedHand, HoldsFromItsFirstWaypointOnInStraightLines) {
  ScriptedHand hand({{1, 0 * kX}, {3, 4 * kX}});
  EXPECT_FALSE(hand.at(0.999).holding);
  EXPECT_TRUE(hand.at(1).holding);
  EXPECT_EQ(hand.at(1.5).position, 1 * kX);
  EXPECT_EQ(hand.at(3).position, 4 * kX);
  EXPECT_EQ(hand.at(1e6).position, 4 * kX);
  EXPECT_TRUE(hand.at(1e6).holding);
  EXPECT_EQ(hand.at(2).position, 2 * kX) << "a session that starts again begins again";
}

TEST(ScriptedHand, LetsGoWithoutWaypoints) {
  EXPECT_FALSE(ScriptedHand({}).at(1).holding);
}

TEST(ScriptedHand, RefusesTimesThatDoNotRiseAndPlacesThatAreNone) {
  EXPECT_THROW(ScriptedHand({{1, kX}, {1, kX}}), std::runtime_error);
  EXPECT_THROW(ScriptedHand({{0, kX * std::numeric_limits<double>::infinity()}}), std::runtime_error);
}

}  // namespace
}  // namespace haptiv
