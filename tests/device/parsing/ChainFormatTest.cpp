#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "device/kinematics/ArmKinematics.h"
#include "tests/device/parsing/Refusal.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

using std::numbers::pi;

TEST(ChainFormat, ReadsJointsEndAndTool) {
  const auto d = parseDeviceDescription(
      "schema = 1\n[[chain.joint]]\naxis = [0, 2, 0]\n[[chain.joint]]\nxyz = [0.5, 0, 0]\nrpy = [0, 0, "
      "1.5707963267948966]\n[chain.end]\nxyz = [0.25, 0, 0]\n[tool]\nxyz = [0, 0, 0.1]\nrpy = [3.141592653589793, 0, "
      "0]\n"
      "[drives]\ngearRatio = [100, 50]\n[home]\nangles = [0.1, 0.2]\n",
      "arm.toml");
  ASSERT_EQ(d.jointCount(), 2);
  EXPECT_EQ(d.chain.joints[0].axis, Vector3::UnitY());
  EXPECT_EQ(d.chain.joints[1].axis, Vector3::UnitZ());
  EXPECT_EQ(d.chain.joints[1].mount.position, Vector3(0.5, 0, 0));
  EXPECT_EQ(d.drives.gearRatio[1], 50);
  EXPECT_EQ(d.homeAngles.head<3>(), Vector3(0.1, 0.2, 0));
  // Joint 2 is turned by a quarter about z: its link and the tool's z point along y and down.
  const Pose X_BT = ArmKinematics(d).forward(JointVector::Zero());
  EXPECT_LT((X_BT.position - Vector3(0.5, 0.25, 0.1)).norm(), 1e-15);
  EXPECT_LT((X_BT.rotation.col(2) + Vector3::UnitZ()).norm(), 1e-15);
}

TEST(ChainFormat, RollPitchAndYawTurnAboutFixedAxesInThisOrder) {
  const auto d = parseDeviceDescription("schema = 1\n[tool]\nrpy = [1.5707963267948966, 1.5707963267948966, 0]\n", "a");
  // y turns to z by the roll, and z to x by the pitch.
  EXPECT_LT((d.tool.rotation * Vector3::UnitY() - Vector3::UnitX()).norm(), 1e-15);
}

TEST(ChainFormat, TheAnthropomorphicArmHasTheParts) {
  const DeviceDescription d = loadDeviceDescription("anthropomorphic7");
  ASSERT_EQ(d.jointCount(), 7);
  const ArmKinematics arm(d);
  test::Random random(1);
  for (int i = 0; i < 50; ++i) {
    const auto q = random.vector<JointVector>(-pi, pi);
    const ArmPose at = arm.evaluate(q);
    EXPECT_EQ((at.J_BT.block<3, 3>(0, 4).norm() < 1e-12), true) << "the wrist's axes meet in the wrist centre";
    const ArmSkeleton skeleton = arm.skeleton(q);
    for (int joint = 0; joint < 3; ++joint) EXPECT_LT(skeleton.at[joint].norm(), 1e-15) << "the shoulder's axes meet";
    EXPECT_NEAR(skeleton.at[3].norm(), 0.5, 1e-12);
    EXPECT_NEAR((at.X_BT.position - skeleton.at[3]).norm(), 0.5, 1e-12);
  }
}

TEST(ChainFormat, TheAnthropomorphicArmStandsLevelAtHome) {
  const DeviceDescription d = loadDeviceDescription("anthropomorphic7");
  const Pose X_BT = ArmKinematics(d).forward(d.homeAngles);
  EXPECT_LT((X_BT.position - Vector3(0.5, 0, 0)).norm(), 1e-12);
  EXPECT_LT((X_BT.rotation - Matrix3::Identity()).norm(), 1e-12);
}

TEST(ChainFormat, RefusesWhatIsNoChainWithLineAndColumn) {
  EXPECT_THAT(refusal("schema = 1\n[chain]\n"), AllOf(StartsWith("arm.toml:2:1: "), HasSubstr("no joints")));
  EXPECT_THAT(refusal("schema = 1\nchain = 3\n"), StartsWith("arm.toml:2:9: "));
  EXPECT_THAT(refusal("schema = 1\n[chain]\njoint = []\n"), StartsWith("arm.toml:3:9: "));
  EXPECT_THAT(refusal("schema = 1\n[chain]\njoint = [1, 2]\n"), StartsWith("arm.toml:3:9: "));
  EXPECT_THAT(refusal("schema = 1\n[chain]\nlinks = 3\n"),
              AllOf(StartsWith("arm.toml:3:1: "), HasSubstr("chain.links")));
  EXPECT_THAT(refusal("schema = 1\n[[chain.joint]]\naxis = [0, 0, 0]\n"),
              AllOf(StartsWith("arm.toml:3:8: "), HasSubstr("direction")));
  EXPECT_THAT(refusal("schema = 1\n[[chain.joint]]\nturns = 3\n"), HasSubstr("chain.joint 1.turns"));
  EXPECT_THAT(refusal("schema = 1\n[[chain.joint]]\nxyz = [0, 0]\n"), HasSubstr("2 entries; give 3"));
  EXPECT_THAT(refusal("schema = 1\n[[chain.joint]]\nxyz = [1000, 0, 0]\n"), HasSubstr("metres"));
  EXPECT_THAT(refusal("schema = 1\n[links]\nscara = 1\n[[chain.joint]]\n"),
              AllOf(StartsWith("arm.toml:2:"), HasSubstr("one of them")));
  std::string eleven = "schema = 1\n";
  for (int i = 0; i < 11; ++i) eleven += "[[chain.joint]]\n";
  EXPECT_THAT(refusal(eleven), AllOf(StartsWith("arm.toml:12:"), HasSubstr("10 joints")));
}

TEST(ChainFormat, AsksForOneEntryAJoint) {
  EXPECT_THAT(refusal("schema = 1\n[[chain.joint]]\n[home]\nangles = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0]\n"),
              HasSubstr("10 entries; give 1"));
}

}  // namespace
}  // namespace haptiv
