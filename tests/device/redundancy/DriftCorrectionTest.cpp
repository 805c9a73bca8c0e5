#include "device/redundancy/DriftCorrection.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "device/kinematics/Vishard10.h"
#include "device/redundancy/FullSolution.h"
#include "tests/device/PaperArm.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

using std::numbers::pi;

TEST(DriftCorrection, IsTheRotationVectorRightUpToHalfATurn) {
  test::Random random(4);
  for (int i = 0; i < 500; ++i) {
    const Vector3 axis = random.vector<Vector3>(-1, 1).normalized();
    const double angle = i % 5 == 0 ? pi - 1e-6 : random.between(0, pi);
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
    q += kPeriod * FullSolution(kArm.jacobian(q), JointVector::Ones(), description.control).leastNorm(twist);
  }
  EXPECT_LT(driftCorrection(desired, kArm.forward(q), 1).norm(), 1e-12);
}

}  // namespace
}  // namespace haptiv
