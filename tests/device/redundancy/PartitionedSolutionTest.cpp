#include "device/redundancy/PartitionedSolution.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/device/redundancy/CircleRun.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

using std::numbers::pi;
const JointVector kEqual = JointVector::Ones();

/// Whether no block is damped.
bool isRegular(const PartitionedSolution& solution, const JointVector& q, const LinkLengths& links) {
  const CriterionPair kappa = solution.values(Strategy::cond), volume = solution.values(Strategy::man);
  const double smallestSigma = std::sqrt(volume.translation / pi / kappa.translation);
  const double lean = q[5] + q[6] / 2, half = q[6] / 2;
  const double lift = 2 * links.lift * std::hypot(std::sin(lean) * std::cos(half), std::cos(lean) * std::sin(half));
  return smallestSigma > 0.15 && kappa.rotation < 5 && lift > 0.15;
}

/// Any pose, any lean of links 6 and 7, any tool.
TEST(PartitionedSolution, MovesTheToolAsWantedAndLeavesItWhereItIsOtherwise) {
  test::Random random(1);
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    DeviceDescription description = loadDeviceDescription("vishard10");
    description.tool.position = random.vector<Vector3>(-0.1, 0.1);
    description.tool.rotation = Eigen::AngleAxisd(random.between(-3, 3), Vector3::UnitY()).toRotationMatrix();
    const JointVector q = random.vector<JointVector>(-pi, pi);
    const Jacobian J = ArmKinematics(description).jacobian(q);
    const PartitionedSolution solution(q, J, kEqual, description.control);
    if (!isRegular(solution, q, description.links)) continue;
    const Vector6 twist = random.vector<Vector6>(-1, 1);
    EXPECT_LT((J * solution.leastNorm(twist) - twist).norm(), 1e-10);
    EXPECT_LT((J * solution.upkeep()).norm(), 1e-10);
    for (const Strategy strategy : {Strategy::man, Strategy::dir, Strategy::cond}) {
      const JointVector selfMotion = solution.selfMotion(strategy, {1, 1});
      EXPECT_LT((J * selfMotion).norm(), 1e-10 * (1 + selfMotion.norm()));
    }
    ++compared;
  }
  EXPECT_GT(compared, 50);
}

TEST(PartitionedSolution, LeavesHeightToJoints6And7AndOrientationToTheWrist) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const ArmKinematics arm(description);
  test::Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Vector3 p_BT = random.vector<Vector3>(-0.3, 0.3);
    const JointVector q = arm.inverse(p_BT, description.homeAngles);  // th7 = -2 th6
    const PartitionedSolution solution(q, arm.jacobian(q), kEqual, description.control);
    Vector6 twist = random.vector<Vector6>(-1, 1);
    const JointVector rates = solution.leastNorm(twist);
    EXPECT_NEAR(rates[6], -2 * rates[5], 1e-12);
    EXPECT_NEAR(rates[6] * description.links.lift * std::sin(q[5]), twist[2], 1e-12);  // eq. (23), differentiated
    twist.head<3>().setZero();
    const JointVector turning = solution.leastNorm(twist);
    EXPECT_NEAR(turning.head<5>().sum(), rates.head<5>().sum(), 1e-12);
    EXPECT_NEAR(turning.segment<3>(5).sum(), rates.segment<3>(5).sum(), 1e-12);
    EXPECT_LT((turning.tail<2>() - rates.tail<2>()).norm(), 1e-12);
    EXPECT_LT(solution.upkeep().norm(), 1e-12);
    EXPECT_LT(turning.head<4>().norm(), 1e-12);  // a turn asks nothing of the SCARA links
  }
}

TEST(PartitionedSolution, BringsLinks6And7BackToAPrismaticJointAndHoldsTheTool) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const ArmKinematics arm(description);
  constexpr double kPeriod = 1e-3;
  for (const double lean : {-1.4, -0.7, 0.3, 1.}) {
    JointVector q = arm.inverse({0.3, 0.1, 0}, description.homeAngles);
    q[5] += lean;  // joint 7 stays
    q[6] = -2.4;   // leans are -1, -0.3, 0.7 and 1.4 rad then
    const Pose start = arm.forward(q);
    double worst = 0;
    for (int tick = 0; tick < 6000; ++tick) {
      const ArmPose pose = arm.evaluate(q);
      const PartitionedSolution solution(q, pose.J_BT, kEqual, description.control);
      const JointVector rates =
          solution.leastNorm(driftCorrection(start, pose.X_BT, description.control.driftGain)) + solution.upkeep();
      worst = std::max(worst, (pose.X_BT.position - start.position).norm());
      ASSERT_LT(rates.cwiseAbs().maxCoeff(), 4);
      q += kPeriod * rates;
    }
    EXPECT_NEAR(std::remainder(q[5] + q[6] / 2, pi), 0, 1e-3) << lean;
    EXPECT_LT(worst, 1e-4) << lean;  // second order in the period: nothing takes it out here but the closed loop
  }
}

TEST(PartitionedSolution, HasBoundedRatesWhereLinks6And7AreStretched) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const ArmKinematics arm(description);
  Vector6 up = Vector6::Zero();
  up[2] = 1;
  for (const double fold : {0.2, 0.1, 0.01, 1e-6, 0.}) {
    JointVector q = arm.inverse({0.3, 0.1, 2 * description.links.lift * std::cos(fold)}, description.homeAngles);
    const JointVector rates = PartitionedSolution(q, arm.jacobian(q), kEqual, description.control).leastNorm(up);
    ASSERT_TRUE(rates.allFinite());
    EXPECT_LT(rates.cwiseAbs().maxCoeff(), 2 / description.control.singularityDamping) << fold;
  }
}

}  // namespace
}  // namespace haptiv
