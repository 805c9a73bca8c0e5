#include "device/kinematics/ArmKinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/device/PaperArm.h"
#include "tests/device/kinematics/Chains.h"

namespace haptiv {
namespace {

using std::numbers::pi;

DeviceDescription asChain() {
  DeviceDescription description = loadDeviceDescription("vishard10");
  description.chain = test::vishard10Chain(description.links);
  return description;
}

TEST(ArmKinematics, ToolIsCarriedByTheWristCentreOfEitherKind) {
  test::Random random(1);
  for (DeviceDescription description : {loadDeviceDescription("vishard10"), asChain()}) {
    const ArmKinematics bare(description);
    description.tool = test::randomPose(random);
    const ArmKinematics arm(description);
    for (int i = 0; i < 100; ++i) {
      const auto q = random.vector<JointVector>(-pi, pi);
      const Pose X_BC = bare.forward(q), X_BT = arm.forward(q);
      EXPECT_LT((X_BC.position + X_BC.rotation * description.tool.position - X_BT.position).norm(), kRounding);
      EXPECT_LT((X_BC.rotation * description.tool.rotation - X_BT.rotation).norm(), kRounding);
      const JointVector rates = random.vector<JointVector>(-1, 1);
      constexpr double kStep = 1e-5;
      const Vector3 moved = arm.forward(q + kStep * rates).position - arm.forward(q - kStep * rates).position;
      EXPECT_LT((arm.jacobian(q).topRows<3>() * rates - moved / (2 * kStep)).norm(), 1e-8);
    }
  }
}

TEST(ArmKinematics, InversePutsTheToolOfEitherKindWhereAskedAndKeepsItsOrientation) {
  test::Random random(2);
  for (DeviceDescription description : {loadDeviceDescription("vishard10"), asChain()}) {
    description.tool.position = Vector3(0.05, 0.02, -0.1);
    const ArmKinematics arm(description);
    const JointVector& home = description.homeAngles;
    for (int i = 0; i < 100; ++i) {
      const Vector3 p(random.between(-0.85, 0.85), random.between(-0.4, 0.4), random.between(-0.3, 0.3));
      const Pose X_BT = arm.forward(arm.inverse(p, home));
      EXPECT_LT((X_BT.position - p).norm(), 1e-9) << p.transpose();
      EXPECT_LT((X_BT.rotation - arm.forward(home).rotation).norm(), 1e-9) << p.transpose();
    }
  }
}

TEST(ArmKinematics, InverseBendsAnArmThatWouldLieStretched) {
  for (const DeviceDescription& description : {loadDeviceDescription("vishard10"), asChain()}) {
    const ArmKinematics arm(description);
    for (const Vector3& p : {Vector3(0.51, 0, 0), Vector3(0.6, 0, 0), Vector3(0.8, 0, 0), Vector3(-0.7, 0, 0)})
      EXPECT_LT((arm.forward(arm.inverse(p, description.homeAngles)).position - p).norm(), 1e-9) << p.transpose();
  }
}

TEST(ArmKinematics, InverseStaysFiniteWhereNoAngleReaches) {
  for (const DeviceDescription& description : {loadDeviceDescription("vishard10"), asChain()}) {
    const ArmKinematics arm(description);
    for (const Vector3& far : {Vector3(3, -4, 5), Vector3(0, 0, -1e9), Vector3(1e300, 0, 0)}) {
      const JointVector q = arm.inverse(far, description.homeAngles);
      EXPECT_TRUE(q.allFinite());
      EXPECT_GT((arm.forward(q).position - far).norm(), 1);
    }
  }
}

}  // namespace
}  // namespace haptiv
