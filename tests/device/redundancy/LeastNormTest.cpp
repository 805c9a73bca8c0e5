#include "device/redundancy/FullSolution.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "device/kinematics/Vishard10.h"
#include "tests/device/PaperArm.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

using std::numbers::pi;
const ControlSettings kControl;

/// As all joints serve all of the motion, and weigh the same.
JointVector leastNormRates(const Jacobian& J, const Vector6& twist, const ControlSettings& control) {
  return FullSolution(J, JointVector::Ones(), control).leastNorm(twist);
}

double manipulability(const Jacobian& J) {
  const Eigen::Matrix<double, 6, 6> gram = J * J.transpose();
  return std::sqrt(std::max(0., gram.determinant()));
}

TEST(LeastNormRates, AreThePseudoinverseAwayFromSingularities) {
  test::Random random(1);
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    const Jacobian J = kArm.jacobian(random.vector<JointVector>(-pi, pi));
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
  // sigma / (sigma^2 + mu^2) <= 1 / (2 mu), and mu falls from its largest as sigma grows: twice that holds.
  const double bound = 1 / kControl.singularityDamping;
  for (const Jacobian& J : poses) {
    ASSERT_LT(manipulability(J), 1e-6);
    for (int i = 0; i < 50; ++i) {
      const Vector6 twist = random.vector<Vector6>(-1, 1);
      const JointVector rates = leastNormRates(J, twist, kControl);
      ASSERT_TRUE(rates.allFinite());
      EXPECT_LE(rates.norm(), bound * twist.norm());
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

TEST(LeastNormRates, StillMoveTheToolExactlyWhereItCanBeMovedAtASingularPose) {
  JointVector q = JointVector::Constant(0.4);
  q[7] = -0.8;
  q[8] = 0;  // no turn about the axis that axes 5, 8, 9 and 10 are perpendicular to
  const Jacobian J = kArm.jacobian(q);
  ASSERT_LT(manipulability(J), 1e-6);
  test::Random random(6);
  for (int i = 0; i < 50; ++i) {
    const Vector6 twist = J * random.vector<JointVector>(-1, 1);
    EXPECT_LT((J * leastNormRates(J, twist, kControl) - twist).norm(), 1e-9 * (1 + twist.norm()));
  }
}

/// Eqs. (7), (8): the rates over their weights are of least norm.
TEST(LeastNormRates, SpareTheJointsThatWeighLess) {
  test::Random random(7);
  int compared = 0;
  for (int i = 0; i < 100; ++i) {
    const JointVector weights = random.vector<JointVector>(0.3, 1);
    const Jacobian J = kArm.jacobian(random.vector<JointVector>(-pi, pi));
    const Jacobian weighted = J * weights.asDiagonal();
    if (manipulability(weighted) < 1.01 * kControl.singularityThreshold) continue;
    const Vector6 twist = random.vector<Vector6>(-1, 1);
    const JointVector expected = weights.cwiseProduct(weighted.completeOrthogonalDecomposition().solve(twist));
    const JointVector rates = FullSolution(J, weights.cwiseAbs2(), kControl).leastNorm(twist);
    EXPECT_LT((rates - expected).norm(), 1e-9 * (1 + expected.norm()));
    ++compared;
  }
  EXPECT_GT(compared, 10);
}

}  // namespace
}  // namespace haptiv
