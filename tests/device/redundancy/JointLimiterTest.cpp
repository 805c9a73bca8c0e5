#include "device/redundancy/JointLimiter.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/Random.h"

namespace haptiv {
namespace {

TEST(JointLimiter, LeavesRatesWithinTheirLimitsAlone) {
  EXPECT_EQ(slowDownFactor(JointVector::Zero(), JointVector::Ones()), 1);
  EXPECT_EQ(slowDownFactor(-JointVector::Ones(), JointVector::Ones()), 1);
}

TEST(JointLimiter, SlowsAllJointsSoThatTheWorstJustMeetsItsLimit) {
  test::Random random(1);
  for (int i = 0; i < 200; ++i) {
    const JointVector limits = random.vector<JointVector>(1, 7);
    const JointVector rates = random.vector<JointVector>(-20, 20);
    const double factor = slowDownFactor(rates, limits);
    const double worst = (factor * rates).cwiseAbs().cwiseQuotient(limits).maxCoeff();
    EXPECT_GE(factor, 0);
    EXPECT_LE(worst, 1 + 1e-15);  // one rounding
    if (factor < 1) {
      EXPECT_NEAR(worst, 1, 1e-15);
    }
  }
}

TEST(JointLimiter, StopsForAnInfiniteRate) {
  JointVector rates = JointVector::Ones();
  rates[3] = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(slowDownFactor(rates, JointVector::Constant(6)), 0);
}

}  // namespace
}  // namespace haptiv
