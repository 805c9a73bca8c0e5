#include "device/redundancy/StepBounds.h"

#include <gtest/gtest.h>

#include "tests/support/Random.h"

namespace haptiv {
namespace {

const JointVector kLimit = JointVector::Constant(4);

TEST(StepBounds, AreTheStepsAtWhichTheFirstJointMeetsItsLimit) {
  test::Random random(1);
  for (int i = 0; i < 200; ++i) {
    const JointVector leastNorm = random.vector<JointVector>(-4, 4);
    const JointVector selfMotion = random.vector<JointVector>(-1, 1);
    const StepBounds bounds = stepBounds(leastNorm, selfMotion, kLimit);
    for (const double step : {bounds.low, bounds.high}) {
      EXPECT_NEAR((leastNorm + step * selfMotion).cwiseAbs().maxCoeff(), 4, 1e-12);
    }
  }
}

TEST(StepBounds, AreOpenWhereNothingMoves) {
  const StepBounds bounds = stepBounds(JointVector::Ones(), JointVector::Zero(), kLimit);
  EXPECT_EQ(boundedStep(7, bounds), 7);
}

TEST(BoundedStep, KeepsRatesWithinTheirLimitsWheneverLeastNormIs) {
  test::Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const JointVector leastNorm = random.vector<JointVector>(-4, 4);
    JointVector selfMotion = random.vector<JointVector>(-9, 9);
    if (i % 3 == 0) selfMotion[i % 10] = 0;
    const double wanted = random.between(0, 5);
    const double step = boundedStep(wanted, stepBounds(leastNorm, selfMotion, kLimit));
    EXPECT_GE(step, 0);
    EXPECT_LE(step, wanted);
    EXPECT_LE((leastNorm + step * selfMotion).cwiseAbs().maxCoeff(), 4 + 1e-14);  // some roundings of 4
  }
}

TEST(BoundedStep, BringsAJointBackWithinItsLimitWhereTheWantedStepCan) {
  JointVector leastNorm = JointVector::Zero(), selfMotion = JointVector::Zero();
  leastNorm[2] = 4.5;
  selfMotion[2] = -1;
  EXPECT_EQ(boundedStep(2, stepBounds(leastNorm, selfMotion, kLimit)), 2);
  EXPECT_EQ(boundedStep(0.2, stepBounds(leastNorm, selfMotion, kLimit)), 0);  // it cannot: no self-motion
  selfMotion[2] = 1;
  EXPECT_EQ(boundedStep(2, stepBounds(leastNorm, selfMotion, kLimit)), 0);  // never against the gradient
}

}  // namespace
}  // namespace haptiv
