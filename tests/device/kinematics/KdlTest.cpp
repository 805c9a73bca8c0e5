#include <gtest/gtest.h>

#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <numbers>

#include "device/kinematics/ArmKinematics.h"
#include "tests/device/PaperArm.h"
#include "tests/device/kinematics/Chains.h"
#include "tests/device/kinematics/ToKdl.h"
#include "tests/support/Random.h"

// Orocos KDL, an implementation of other people, sees the same arms.

namespace haptiv {
namespace {

using std::numbers::pi;

/// Pose and Jacobian of the arm against those of the same arm in KDL, over random joint angles.
void expectSameAsKdl(const DeviceDescription& description, const ChainGeometry& geometry) {
  const ArmKinematics arm(description);
  KDL::Chain chain = test::toKdl(geometry, description.tool);
  KDL::ChainFkSolverPos_recursive forward(chain);
  KDL::ChainJntToJacSolver jacobian(chain);
  KDL::JntArray angles(chain.getNrOfJoints());
  KDL::Jacobian J(chain.getNrOfJoints());
  ASSERT_EQ(static_cast<int>(chain.getNrOfJoints()), arm.jointCount());
  test::Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const auto q = random.vector<JointVector>(-pi, pi);
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
