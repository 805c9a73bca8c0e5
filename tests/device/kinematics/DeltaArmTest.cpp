#include "device/kinematics/DeltaArm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "device/described/DeviceDescription.h"
#include "device/kinematics/ArmKinematics.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

/// A few roundings of h, which is in m^2, over its slope of some 0.1 m.
constexpr double kPlace = 1e-12;  // [m]

const DeltaArm kFalcon{DeltaGeometry{}};

/// Somewhere in the ball of 40 mm about the middle of a Falcon's workspace.
Vector3 randomPlace(test::Random& random) {
  Vector3 away = random.vector<Vector3>(-0.04, 0.04);
  while (away.norm() > 0.04) away = random.vector<Vector3>(-0.04, 0.04);
  return Vector3(0, 0, 0.115) + away;
}

TEST(DeltaArm, ForwardUndoesInverseAllOverTheWorkspace) {
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vector3 p = randomPlace(random);
    ASSERT_TRUE(kFalcon.reaches(p)) << p.transpose();
    const Pose X_BT = kFalcon.forward(kFalcon.inverse(p));
    EXPECT_LT((X_BT.position - p).norm(), kPlace) << p.transpose();
    EXPECT_EQ(X_BT.rotation, Matrix3::Identity());
  }
}

TEST(DeltaArm, EveryLegIsAsLongAsItIsBuilt) {
  const DeltaGeometry g;
  test::Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Vector3 p = randomPlace(random);
    const ArmSkeleton at = kFalcon.skeleton(kFalcon.inverse(p));
    ASSERT_EQ(at.count, 11);
    for (const auto& [base, elbow, end, leg] : {std::array{0, 1, 2, 0}, {6, 5, 4, 1}, {7, 8, 9, 2}}) {
      EXPECT_NEAR((at.at[base] - at.at[elbow]).norm(), g.upperArm, kPlace);
      // The forearm's hinges lie in the leg's plane, the parallelogram's sides lean out of it by v.
      const Vector3 v(-std::sin(g.legAngles[leg]), std::cos(g.legAngles[leg]), 0);
      const Vector3 forearm = at.at[end] - at.at[elbow];
      const double out = forearm.dot(v);
      const double inPlane = (forearm - out * v).norm();
      EXPECT_NEAR(std::hypot(inPlane - g.hinges, out), g.forearm, kPlace);
    }
  }
}

TEST(DeltaArm, JacobianIsTheSlopeOfForward) {
  test::Random random(3);
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 500; ++i) {
    const JointVector q = kFalcon.inverse(randomPlace(random));
    const Jacobian J = kFalcon.evaluate(q).J_BT;
    JointVector rates = JointVector::Zero();
    rates.head<3>() = random.vector<Vector3>(-1, 1);
    const Vector3 moved = kFalcon.forward(q + kStep * rates).position - kFalcon.forward(q - kStep * rates).position;
    // The third derivative over 6, times the step squared, stays below 1e-7 m/s away from the workspace's edge.
    EXPECT_LT((J.topRows<3>() * rates - moved / (2 * kStep)).norm(), 1e-7) << q.head<3>().transpose();
    EXPECT_TRUE(J.bottomRows<3>().isZero(0)) << "the handle never turns";
    EXPECT_TRUE(J.rightCols<7>().isZero(0)) << "there are three joints";
  }
}

TEST(DeltaArm, StandsOnItsAxisWhereAllLegsAreAlike) {
  for (const double angle : {0., 0.3, 0.6, 0.9}) {
    const Vector3 p = kFalcon.forward(JointVector::Constant(angle)).position;
    EXPECT_LT(p.head<2>().norm(), kPlace);
    const JointVector q = kFalcon.inverse(p);
    EXPECT_NEAR(q[0], angle, 1e-9);
    EXPECT_NEAR(q[1], angle, 1e-9);
    EXPECT_NEAR(q[2], angle, 1e-9);
  }
}

TEST(DeltaArm, DrawsAPlaceOutOfReachIn) {
  test::Random random(4);
  for (int i = 0; i < 500; ++i) {
    const Vector3 p = random.vector<Vector3>(-0.5, 0.5);
    const Vector3 reached = kFalcon.forward(kFalcon.inverse(p)).position;
    ASSERT_TRUE(reached.allFinite());
    // At the very edge two legs may be stretched: J is singular there, and h's roundings count by their roots.
    EXPECT_LT((kFalcon.forward(kFalcon.inverse(reached)).position - reached).norm(), 1e-5) << p.transpose();
    if (kFalcon.reaches(p)) {
      EXPECT_LT((reached - p).norm(), 1e-6) << p.transpose();
    } else {
      EXPECT_GT((reached - p).norm(), 1e-6) << p.transpose();
    }
  }
}

TEST(DeltaArm, IsNeverNoNumberWhateverItsAngles) {
  test::Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const ArmPose arm = kFalcon.evaluate(random.vector<JointVector>(-100, 100));
    EXPECT_TRUE(arm.X_BT.position.allFinite());
    EXPECT_TRUE(arm.J_BT.allFinite());
  }
  for (const double far : {1e9, -1e9, 1e300}) EXPECT_TRUE(kFalcon.inverse({far, far, far}).allFinite()) << far;
}

TEST(DeltaArm, ForcesAndTorquesDoTheSameWork) {
  test::Random random(6);
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 200; ++i) {
    const JointVector q = kFalcon.inverse(randomPlace(random));
    const auto force = random.vector<Vector3>(-8, 8);
    const JointVector torques = kFalcon.evaluate(q).J_BT.topRows<3>().transpose() * force;
    JointVector turn = JointVector::Zero();
    turn.head<3>() = kStep * random.vector<Vector3>(-1, 1);
    const Vector3 way = kFalcon.forward(q + turn).position - kFalcon.forward(q - turn).position;
    EXPECT_NEAR(torques.dot(2 * turn), force.dot(way), 1e-11);  // J's error of 1e-7 times 8 N times the way
  }
}

TEST(DeltaArm, IsTheArmOfADescriptionThatSaysSo) {
  DeviceDescription description = loadDeviceDescription("falcon");
  ASSERT_EQ(description.jointCount(), 3);
  EXPECT_EQ(description.type, DeviceType::impedance);
  description.tool.position = Vector3(0.01, 0.02, 0.03);
  const ArmKinematics arm(description);
  ASSERT_NE(arm.delta(), nullptr);
  EXPECT_EQ(arm.vishard10(), nullptr);
  EXPECT_EQ(arm.jointCount(), 3);
  const Vector3 p(0.02, 0.01, 0.14);
  EXPECT_LT((arm.forward(arm.inverse(p, description.homeAngles)).position - p).norm(), kPlace);
  // A count is 0.03643 degrees, as those who have a Falcon tell.
  EXPECT_NEAR(360 / (2 * std::numbers::pi * description.drives.countsPerRadian()[0]), 0.03643, 1e-5);
}

}  // namespace
}  // namespace haptiv
