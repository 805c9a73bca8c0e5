#include <gtest/gtest.h>

#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <numbers>

#include "device/kinematics/ArmKinematics.h"
#include "tests/device/kinematics/Chains.h"
#include "tests/support/Random.h"

// Orocos KDL, an implementation of other people, sees the same arms.

namespace haptiv {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-12;  // a few hundred roundings of quantities near one

KDL::Vector toKdl(const Vector3& v) {
  return {v.x(), v.y(), v.z()};
}
KDL::Frame toKdl(const Pose& pose) {
  const Matrix3& R = pose.rotation;
  return {KDL::Rotation(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)),
          toKdl(pose.position)};
}

KDL::Chain toKdl(const ChainGeometry& geometry, const Pose& tool) {
  KDL::Chain chain;
  for (const ChainJoint& joint : geometry.joints) {
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), toKdl(joint.mount)));
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Vector::Zero(), toKdl(joint.axis), KDL::Joint::RotAxis)));
  }
  chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), toKdl(geometry.end) * toKdl(tool)));
  return chain;
}

/// Pose and Jacobian of the arm against those of the same arm in KDL, over random joint angles.
void expectSameAsKdl(const DeviceDescription& description, const ChainGeometry& geometry) {
  const ArmKinematics arm(description);
  KDL::Chain chain = toKdl(geometry, description.tool);
  KDL::ChainFkSolverPos_recursive forward(chain);
  KDL::ChainJntToJacSolver jacobian(chain);
  KDL::JntArray angles(chain.getNrOfJoints());
  KDL::Jacobian J(chain.getNrOfJoints());
  ASSERT_EQ(static_cast<int>(chain.getNrOfJoints()), arm.jointCount());
  test::Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const auto q = random.vector<JointVector>(-kPi, kPi);
    angles.data = q.head(arm.jointCount());
    KDL::Frame frame;
    ASSERT_EQ(forward.JntToCart(angles, frame), 0);
    ASSERT_EQ(jacobian.JntToJac(angles, J), 0);
    const ArmPose at = arm.evaluate(q);
    for (int row = 0; row < 3; ++row) {
      ASSERT_NEAR(at.X_BT.position[row], frame.p(row), kRounding);
      for (int column = 0; column < 3; ++column)
        ASSERT_NEAR(at.X_BT.rotation(row, column), frame.M(row, column), kRounding);
    }
    ASSERT_LT((at.J_BT.leftCols(arm.jointCount()) - J.data).cwiseAbs().maxCoeff(), kRounding);
    ASSERT_EQ(at.J_BT.rightCols(kJointCount - arm.jointCount()).norm(), 0);
  }
}

TEST(Kdl, SeesVishard10AsItsClosedFormsDo) {
  DeviceDescription description = loadDeviceDescription("vishard10");
  test::Random random(2);
  description.tool = test::randomPose(random);
  expectSameAsKdl(description, test::vishard10Chain(description.links));
}

TEST(Kdl, SeesTheAnthropomorphicArmAsTheSerialChainDoes) {
  const DeviceDescription description = loadDeviceDescription("anthropomorphic7");
  expectSameAsKdl(description, description.chain);
}

TEST(Kdl, SeesAnyChainAsTheSerialChainDoes) {
  DeviceDescription description;
  test::Random random(3);
  description.chain = test::randomChain(random, 5);
  expectSameAsKdl(description, description.chain);
}

}  // namespace
}  // namespace haptiv
