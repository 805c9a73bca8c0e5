#include "device/redundancy/DriftCorrection.h"
#include "device/redundancy/LeastNorm.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "device/kinematics/Vishard10.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

constexpr double kPi = std::numbers::pi;
const Vishard10 kArm{LinkLengths{}};
const ControlSettings kControl;

double manipulability(const Jacobian& J) {
  const Eigen::Matrix<double, 6, 6> gram = J * J.transpose();
  return std::sqrt(std::max(0., gram.determinant()));
}

TEST(LeastNormRates, AreThePseudoinverseAwayFromSingularities) {
  test::Random random(1);
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    const Jacobian J = kArm.jacobian(random.vector<JointVector>(-kPi, kPi));
    if (manipulability(J) < 1.01 * kControl.singularityThreshold) continue;
    const Vector6 twist = random.vector<Vector6>(-1, 1);
    const JointVector expected = J.completeOrthogonalDecomposition().solve(twist);
    // The normal equations square the condition number, here below 10^3: 10^6 roundings.
    EXPECT_LT((leastNormRates(J, twist, kControl) - expected).norm(), 1e-9 * (1 + expected.norm()));
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

TEST(LeastNormRates, MoveTheToolAsWantedAllOverTheWorkspace) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  test::Random random(2);
  for (int i = 0; i < 300; ++i) {
    const Vector3 p(random.between(-0.4, 0.45), random.between(-0.45, 0.45), random.between(-0.3, 0.3));
    const Jacobian J = kArm.jacobian(kArm.inverse(p, description.homeAngles));
    ASSERT_GT(manipulability(J), description.control.singularityThreshold) << p.transpose();
    const Vector6 twist = random.vector<Vector6>(-1, 1);
    EXPECT_LT((J * leastNormRates(J, twist, description.control) - twist).norm(), 1e-10);
  }
}

TEST(LeastNormRates, StayBoundedAndFiniteAtSingularPoses) {
  test::Random random(3);
  JointVector stretched = JointVector::Zero();
  JointVector upright = random.vector<JointVector>(-1, 1);
  upright[7] = -upright[5] - upright[6];  // axis 9 upright, as axis 5 is
  upright[8] = 0;                         // axes 8 and 10 parallel
  const Jacobian poses[] = {kArm.jacobian(stretched), kArm.jacobian(upright), Jacobian::Zero(),
                            kArm.jacobian(kArm.inverse({0.5, 0, 0}, stretched))};
  // At a singular pose |J^T (J J^T + mu^2 I)^-1| <= 1 / (2 mu).
  const double bound = 1 / (2 * kControl.singularityDamping);
  for (const Jacobian& J : poses) {
    ASSERT_LT(manipulability(J), 1e-6);
    for (int i = 0; i < 50; ++i) {
      const Vector6 twist = random.vector<Vector6>(-1, 1);
      const JointVector rates = leastNormRates(J, twist, kControl);
      ASSERT_TRUE(rates.allFinite());
      EXPECT_LE(rates.norm(), 1.001 * bound * twist.norm());
    }
  }
}

TEST(LeastNormRates, HaveNoStepOnTheWayThroughASingularity) {
  JointVector q = JointVector::Constant(0.4);
  q[7] = -0.8;  // th8* = 0: singular where th9 = 0
  Vector6 twist = Vector6::Zero();
  twist.tail<3>() = Vector3(0.3, 0.2, 0.1);
  constexpr double kStep = 1e-5;
  double smallest = 1;
  q[8] = -0.3;
  JointVector before = leastNormRates(kArm.jacobian(q), twist, kControl);
  for (; q[8] < 0.3; q[8] += kStep) {
    const JointVector rates = leastNormRates(kArm.jacobian(q), twist, kControl);
    // The slope is of the order of |twist| / mu^2, 400 times the twist per rad, and as much again as mu changes;
    // a step, of rates of 8 rad/s, would be a thousand times more.
    ASSERT_LT((rates - before).norm(), 1000 * twist.norm() * kStep) << "at th9 = " << q[8];
    smallest = std::min(smallest, manipulability(kArm.jacobian(q)));
    before = rates;
  }
  EXPECT_LT(smallest, 1e-5);  // the way did lead through a singularity
}

TEST(DriftCorrection, IsTheRotationVectorRightUpToHalfATurn) {
  test::Random random(4);
  for (int i = 0; i < 500; ++i) {
    const Vector3 axis = random.vector<Vector3>(-1, 1).normalized();
    const double angle = i % 5 == 0 ? kPi - 1e-6 : random.between(0, kPi);
    Pose actual, desired;
    actual.rotation = Eigen::AngleAxisd(random.between(-3, 3), random.vector<Vector3>(-1, 1).normalized());
    actual.position = random.vector<Vector3>(-1, 1);
    desired.rotation = Eigen::AngleAxisd(angle, axis) * actual.rotation;
    desired.position = random.vector<Vector3>(-1, 1);
    const Vector6 twist = driftCorrection(desired, actual, 2);
    EXPECT_LT((twist.head<3>() - 2 * (desired.position - actual.position)).norm(), 1e-14);
    EXPECT_LT((twist.tail<3>() - 2 * angle * axis).norm(), 1e-12);
  }
}

TEST(DriftCorrection, IsZeroWhereNothingHasDrifted) {
  Pose pose;
  pose.position = Vector3(1, 2, 3);
  EXPECT_EQ(driftCorrection(pose, pose, 50), Vector6::Zero());
}

TEST(DriftCorrection, BringsTheToolBack) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  JointVector q = description.homeAngles;
  const Pose desired = kArm.forward(q);
  q += test::Random(5).vector<JointVector>(-0.05, 0.05);
  constexpr double kPeriod = 1e-3;
  for (int tick = 0; tick < 1000; ++tick) {  // 50 time constants
    const Vector6 twist = driftCorrection(desired, kArm.forward(q), description.control.driftGain);
    q += kPeriod * leastNormRates(kArm.jacobian(q), twist, description.control);
  }
  EXPECT_LT(driftCorrection(desired, kArm.forward(q), 1).norm(), 1e-12);
}

}  // namespace
}  // namespace haptiv
