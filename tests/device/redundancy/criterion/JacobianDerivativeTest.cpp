#include "device/redundancy/criterion/JacobianDerivative.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "device/kinematics/Vishard10.h"
#include "device/redundancy/DriftCorrection.h"
#include "device/redundancy/ToolDisplacement.h"
#include "tests/device/PaperArm.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

using std::numbers::pi;
/// Of central differences: the step's square times third derivatives near one, and the values' rounding over the step.
constexpr double kMove = 1e-5, kTolerance = 1e-9;

TEST(JacobianDerivative, IsWhatCentralDifferencesSay) {
  test::Random random(1);
  for (int i = 0; i < 100; ++i) {
    const JointVector q = random.vector<JointVector>(-pi, pi);
    for (int k = 0; k < kJointCount; ++k) {
      const JointVector step = kMove * JointVector::Unit(k);
      const Jacobian difference = (kArm.jacobian(q + step) - kArm.jacobian(q - step)) / (2 * kMove);
      EXPECT_LT((jacobianDerivative(kArm.jacobian(q), k) - difference).norm(), kTolerance);
    }
  }
}

TEST(JacobianDerivative, IsContractedInOnePass) {
  test::Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Jacobian J = kArm.jacobian(random.vector<JointVector>(-pi, pi));
    const JointVector rates = random.vector<JointVector>(-1, 1);
    Jacobian P;
    for (int k = 0; k < kJointCount; ++k) P.col(k) = random.vector<Vector6>(-1, 1);
    const JacobianBlock upper = P.topRows<3>(), lower = P.bottomRows<3>();
    const JointVector linear = gradientByLinearRows(J, upper);
    const JointVector angular = gradientByAngularRows(J.bottomRows<3>(), lower);
    Vector6 acceleration = Vector6::Zero();
    for (int k = 0; k < kJointCount; ++k) {
      const Jacobian dJ = jacobianDerivative(J, k);
      EXPECT_NEAR(linear[k], (dJ.topRows<3>().array() * upper.array()).sum(), 1e-13);
      EXPECT_NEAR(angular[k], (dJ.bottomRows<3>().array() * lower.array()).sum(), 1e-13);
      acceleration += dJ * rates * rates[k];
    }
    EXPECT_LT((toolAcceleration(J, rates) - acceleration).norm(), 1e-13);
  }
}

TEST(ToolDisplacement, IsWhatForwardKinematicsSays) {
  test::Random random(3);
  for (const double size : {1e-6, 1e-3, 4e-3}) {  // the last is 4 rad/s for 1 ms: turns of up to 0.02 rad
    for (int i = 0; i < 100; ++i) {
      const JointVector q = random.vector<JointVector>(-pi, pi);
      const JointVector step = random.vector<JointVector>(-size, size);
      const Vector6 moved = driftCorrection(kArm.forward(q + step), kArm.forward(q), 1);
      EXPECT_LT((toolDisplacement(kArm.jacobian(q), step) - moved).norm(), 1e-14 + 0.1 * std::pow(5 * size, 5)) << size;
    }
  }
  const JointVector far = JointVector::Constant(0.3);
  const Vector3 moved = kArm.forward(far).position - kArm.forward(JointVector::Zero()).position;
  EXPECT_LT((toolDisplacement(kArm.jacobian(JointVector::Zero()), far).head<3>() - moved).norm(), 1e-14);
}

}  // namespace
}  // namespace haptiv
