#include "device/kinematics/SerialChain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "device/kinematics/ArmKinematics.h"
#include "tests/device/PaperArm.h"
#include "tests/device/kinematics/Chains.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

using std::numbers::pi;

TEST(SerialChain, AgreesWithVishard10sClosedForms) {
  const SerialChain chain(test::vishard10Chain(LinkLengths{}));
  const Vishard10 closed{LinkLengths{}};
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const auto q = random.vector<JointVector>(-pi, pi);
    const ArmPose a = chain.evaluate(q), b = closed.evaluate(q);
    ASSERT_LT((a.X_BT.position - b.X_BT.position).norm(), kRounding);
    ASSERT_LT((a.X_BT.rotation - b.X_BT.rotation).norm(), kRounding);
    ASSERT_LT((a.J_BT - b.J_BT).norm(), kRounding);
  }
}

TEST(SerialChain, JacobianIsTheDerivativeOfThePlaceForAnyChain) {
  test::Random random(2);
  for (int i = 0; i < 50; ++i) {
    const SerialChain chain(test::randomChain(random, 1 + i % kJointCount));
    const auto q = random.vector<JointVector>(-pi, pi);
    const ArmPose arm = chain.evaluate(q);
    for (int joint = 0; joint < kJointCount; ++joint) {
      constexpr double kStep = 1e-5;  // error of a central difference: step^2 / 6 times a reach of a few metres
      const JointVector dq = kStep * JointVector::Unit(joint);
      const Vector3 slope = (chain.forward(q + dq).position - chain.forward(q - dq).position) / (2 * kStep);
      EXPECT_LT((arm.J_BT.col(joint).head<3>() - slope).norm(), 1e-8);
      if (joint >= chain.jointCount()) {
        EXPECT_EQ(arm.J_BT.col(joint).norm(), 0);
      }
    }
  }
}

TEST(SerialChain, SkeletonGoesFromTheFirstJointToTheEnd) {
  test::Random random(3);
  const SerialChain chain(test::randomChain(random, 7));
  const auto q = random.vector<JointVector>(-pi, pi);
  const ArmSkeleton skeleton = chain.skeleton(q);
  ASSERT_EQ(skeleton.count, 8);
  EXPECT_LT((skeleton.at[7] - chain.forward(q).position).norm(), kRounding);
}

TEST(SerialChain, RefusesWhatIsNoChain) {
  ChainGeometry chain;
  EXPECT_THROW(SerialChain{chain}, std::invalid_argument);
  chain.joints.resize(kJointCount + 1);
  EXPECT_THROW(SerialChain{chain}, std::invalid_argument);
  chain.joints.resize(1);
  EXPECT_NO_THROW(SerialChain{chain});
  chain.joints[0].axis *= 2;
  EXPECT_THROW(SerialChain{chain}, std::invalid_argument);
}

}  // namespace
}  // namespace haptiv
