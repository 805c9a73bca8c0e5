#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

#include "device/simulated/HumanHand.h"
#include "device/simulated/ScriptedHand.h"

namespace haptiv {
namespace {

const Vector3 kX = Vector3::UnitX();
constexpr double kSubstep = 0.125e-3;

/// A hand at a handle that is held at a place.
struct HandRig {
  Vector3 pull(const HandTarget& target) { return hand.pull(target, handle, motion, kSubstep).force; }
  Vector3 pullFor(double seconds, const HandTarget& target) {
    Vector3 force = Vector3::Zero();
    for (double t = 0; t < seconds; t += kSubstep) force = pull(target);
    return force;
  }
  HandModel model;
  HumanHand hand{model};
  Pose handle;
  Twist motion;
};

TEST(HumanHand, PullsWithItsStiffnessOnceItHasSettled) {
  // Grip and arm swing out with a time constant of less than 2 m / b_grip, 40 ms.
  EXPECT_LT((HandRig().pullFor(2, {true, 0.05 * kX}) - 400 * 0.05 * kX).norm(), 1e-9);
}

TEST(HumanHand, TakesHoldWithoutAJerkEvenOfAMovingHandle) {
  HandRig rig;
  rig.handle.position = Vector3(0.2, 0, 0);
  rig.motion.linear = Vector3(0, 0.5, 0);
  EXPECT_EQ(rig.pull({true, Vector3(1, 1, 1)}), Vector3::Zero());
}

TEST(HumanHand, MakesNoSpikesOfATargetThatMovesInSteps) {
  HandRig rig;
  Vector3 before = Vector3::Zero();
  for (int i = 0; i < 8000; ++i) {
    const Vector3 target = 0.01 * (i / 128) * kX;  // a mouse at 62 Hz
    const Vector3 force = rig.pull({true, target});
    // Steps of 0.01 m changed the force of a hand without mass by b w^2 0.01 dt at once, and its spring adds k v dt.
    EXPECT_LT((force - before).norm(), 4 * 20 * 1600 * 0.01 * kSubstep + 400 * 1. * kSubstep);
    before = force;
  }
}

TEST(HumanHand, PullsWithItsPeakForceWhereItsTargetIsOutOfReachAndItsMassAddsLittle) {
  HandRig rig;
  double strongest = 0;
  for (int i = 0; i < 16000; ++i) strongest = std::max(strongest, rig.pull({true, Vector3(3, -4, 5)}).norm());
  EXPECT_LT(strongest, 1.25 * 170);  // it swings into its grip once
  EXPECT_NEAR(rig.pull({true, Vector3(3, -4, 5)}).norm(), 170, 1e-6);
}

TEST(HumanHand, ItsMassIsFeltWhereItsArmIsSlack) {
  HandRig rig;
  rig.model.stiffness = rig.model.damping = 0;
  rig.hand = HumanHand(rig.model);
  Vector3 force = Vector3::Zero();
  for (double t = 0; t < 1; t += kSubstep) {  // the handle accelerates at 2 m/s^2
    rig.handle.position = t * t * kX;
    rig.motion.linear = 2 * t * kX;
    force = rig.pull({true, Vector3::Zero()});
  }
  EXPECT_NEAR(force.x(), -2 * rig.model.mass, 0.01);
}

TEST(HumanHand, SlipsBeyondItsStrengthAndHasLostTheHandleUntilItTakesHoldAnew) {
  HandRig rig;
  rig.model.gripStrength = 100;
  rig.hand = HumanHand(rig.model);
  double strongest = 0;
  for (int i = 0; i < 8000; ++i) strongest = std::max(strongest, rig.pull({true, kX}).norm());
  EXPECT_NEAR(strongest, 100, 1e-9);
  EXPECT_EQ(rig.pull({true, kX}), Vector3::Zero()) << "it is lost";
  rig.pull({false, kX});
  EXPECT_NEAR(rig.pullFor(2, {true, 0.1 * kX}).x(), 40, 1e-6);
}

TEST(HumanHand, HasNoForceWhenItHasLetGoAndStartsAnew) {
  HandRig rig;
  rig.pullFor(0.3, {true, kX});
  EXPECT_EQ(rig.pull({false, kX}), Vector3::Zero());
  EXPECT_EQ(rig.pull({true, kX}), Vector3::Zero());
}

TEST(HumanHand, LetsGoWhereItsTargetIsNoPlace) {
  HandRig rig;
  rig.pullFor(0.1, {true, kX});
  EXPECT_EQ(rig.pull({true, Vector3::Constant(std::numeric_limits<double>::quiet_NaN())}), Vector3::Zero());
}

Matrix3 turnAboutZ(double angle) {
  return Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix();
}

TEST(HumanHand, HoldsTheOrientationInWhichItTookHold) {
  HandRig rig;
  rig.handle.rotation = turnAboutZ(0.5);
  EXPECT_EQ(rig.hand.pull({true}, rig.handle, {}, kSubstep).torque, Vector3::Zero());
  rig.handle.rotation = turnAboutZ(0.6);
  EXPECT_NEAR(rig.hand.pull({true}, rig.handle, {}, kSubstep).torque.z(), -3 * 0.1, 1e-9);
  rig.motion.angular = Vector3(0, 0, 2);
  EXPECT_NEAR(rig.hand.pull({true}, rig.handle, rig.motion, kSubstep).torque.z(), -3 * 0.1 - 0.15 * 2, 1e-9);
}

TEST(HumanHand, TurnsTheHandleToWhereItWantsItNoHarderThanItCan) {
  HandRig rig;
  HandTarget target{true};
  target.orientation = turnAboutZ(0.4);
  Wrench wrench;
  for (int i = 0; i < 8000; ++i) wrench = rig.hand.pull(target, rig.handle, rig.motion, kSubstep);
  EXPECT_NEAR(wrench.torque.z(), 3 * 0.4, 1e-6);
  target.orientation = turnAboutZ(3.1);
  for (int i = 0; i < 8000; ++i) wrench = rig.hand.pull(target, rig.handle, rig.motion, kSubstep);
  EXPECT_NEAR(wrench.torque.z(), 8, 1e-9);
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

TEST(ScriptedHand, PressesWhatItsWaypointsSayFromThenOn) {
  ScriptedHand hand({{1, kX}, {2, kX, kInputDeadMan | kInputEmergencyStop1}, {3, kX, kInputReset}});
  EXPECT_EQ(hand.at(0.5).inputs, kInputDeadMan);
  EXPECT_EQ(hand.at(1.9).inputs, kInputDeadMan);
  EXPECT_EQ(hand.at(2).inputs, kInputDeadMan | kInputEmergencyStop1);
  EXPECT_EQ(hand.at(9).inputs, kInputReset);
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
