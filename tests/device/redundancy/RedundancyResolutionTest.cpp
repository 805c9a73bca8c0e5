#include "device/redundancy/RedundancyResolution.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>

#include "device/redundancy/criterion/Criterion.h"
#include "tests/device/kinematics/Chains.h"
#include "tests/device/redundancy/CircleRun.h"

namespace haptiv {
namespace {

constexpr double kPeriod = 1e-3;

/// Choices, one a test: VISHARD10 with the steps and weights of its description.
class Resolution : public ::testing::TestWithParam<ResolutionChoice> {
 protected:
  static void SetUpTestSuite() { resolution_ = std::make_unique<RedundancyResolution>(description_); }
  static void TearDownTestSuite() { resolution_.reset(); }

  inline static const DeviceDescription description_ = test::circleDevice();
  inline static std::unique_ptr<RedundancyResolution> resolution_;
  const ArmKinematics arm_{description_};
};

std::string nameOfChoice(const ::testing::TestParamInfo<ResolutionChoice>& info) {
  return nameOf(info.param.solution) + "_" + nameOf(info.param.strategy);
}

std::vector<ResolutionChoice> allChoices() {
  std::vector<ResolutionChoice> choices;
  for (const Solution solution : kSolutions) {
    for (const Strategy strategy : kStrategies) choices.push_back({strategy, solution});
  }
  return choices;
}

INSTANTIATE_TEST_SUITE_P(Of, Resolution, ::testing::ValuesIn(allChoices()), nameOfChoice);

/// Circles at 1 m/s, through the rotational singularities that full nonopt runs into.
TEST_P(Resolution, TracksCirclesWithinATenthOfAMillimetreAndTheRateLimits) {
  for (const double r : {0.05, 0.4, 0.8}) {
    double worst = 0, fastest = 0, smallest = 1, least = 1e9, greatest = 0;
    test::runCircle(description_, *resolution_, GetParam(), r, [&](const test::CircleTick& tick) {
      const Dexterity rotational = rotationalDexterity(tick.pose.J_BT);
      worst = std::max(worst, tick.positionError);
      fastest = std::max(fastest, tick.rates.cwiseAbs().cwiseQuotient(description_.drives.rateLimit).maxCoeff());
      smallest = std::min(smallest, rotational.sigma[2]);
      least = std::min(least, rotational.directional());
      greatest = std::max(greatest, rotational.directional());
    });
    EXPECT_LT(worst, 1e-4) << r;
    EXPECT_LT(fastest, 1.002) << r;  // self-motion's correction for a tick being finite comes on top of its bounds
    if (GetParam().strategy != Strategy::nonopt) {
      EXPECT_GT(smallest, 0.3) << r;
    } else if (GetParam().solution == Solution::partitioned) {
      EXPECT_LT(greatest - least, 1e-12) << r;
    } else {
      EXPECT_EQ(smallest<0.05, r> 0.3) << r;
    }
  }
}

/// By forward kinematics, and so of whatever order: the tool is to stand still, the arm moves for a period.
TEST_P(Resolution, LeavesTheToolWithinANanometreWhileTheArmMovesItself) {
  double moved = 0, fastest = 0;
  for (const double r : test::kRadii) {
    JointVector q = test::circleStart(description_.links, r);
    for (int tick = 0; tick < 200; ++tick) {
      const ArmPose pose = arm_.evaluate(q);
      const JointVector rates = resolution_->rates(GetParam(), q, pose.J_BT, Vector6::Zero(), kPeriod);
      q += kPeriod * rates;
      moved = std::max(moved, driftCorrection(arm_.forward(q), pose.X_BT, 1).norm());  // [m], [rad]
      fastest = std::max(fastest, rates.cwiseAbs().maxCoeff());
    }
  }
  EXPECT_LT(moved, 1e-9);
  EXPECT_EQ(fastest > 0.1, GetParam().strategy != Strategy::nonopt);
}

TEST_P(Resolution, KeepsRatesWithinTheirLimitsWhereLeastNormDoes) {
  const ResolutionChoice leastNorm{Strategy::nonopt, GetParam().solution};
  const JointVector& limit = description_.drives.rateLimit;
  test::Random random(1);
  int kept = 0;
  for (int i = 0; i < 500; ++i) {
    const JointVector q = random.vector<JointVector>(-3, 3);
    const Jacobian J = arm_.jacobian(q);
    const Vector6 twist = random.vector<Vector6>(-1, 1);
    const JointVector without = resolution_->rates(leastNorm, q, J, twist, 0);
    if ((without.array().abs() > limit.array()).any()) continue;
    const JointVector rates = resolution_->rates(GetParam(), q, J, twist, 0);
    EXPECT_LE(rates.cwiseAbs().cwiseQuotient(limit).maxCoeff(), 1 + 1e-14);
    ++kept;
  }
  EXPECT_GT(kept, 50);
}

TEST_P(Resolution, GivesZeroRatesForWhatIsNotFinite) {
  const JointVector q = description_.homeAngles;
  const Jacobian J = arm_.jacobian(q);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (int i = 0; i < 6; ++i) {
      Vector6 twist = Vector6::Ones();
      twist[i] = bad;
      EXPECT_EQ(resolution_->rates(GetParam(), q, J, twist, kPeriod), JointVector::Zero());
    }
    Jacobian broken = J;
    broken(4, 7) = bad;
    EXPECT_EQ(resolution_->rates(GetParam(), q, broken, Vector6::Ones(), kPeriod), JointVector::Zero());
  }
}

TEST_P(Resolution, HasBoundedRatesAtSingularPosesAndAnywhereElse) {
  test::Random random(2);
  std::vector<JointVector> poses = {JointVector::Zero(), arm_.inverse({0.5, 0, 0}, JointVector::Zero()),
                                    arm_.inverse({0.3, 0, 0.424}, description_.homeAngles)};
  for (int i = 0; i < 200; ++i) {
    poses.push_back(random.vector<JointVector>(-3, 3));
    if (i % 2 == 0) poses.back()[8] = 0;
  }
  for (const JointVector& q : poses) {
    const Vector6 twist = random.vector<Vector6>(-1, 1);
    const JointVector rates = resolution_->rates(GetParam(), q, arm_.jacobian(q), twist, 0);
    ASSERT_TRUE(rates.allFinite());
    // At most 1 / mu and some for least norm; in the partitioned solution joints 1 to 4 carry the others' share.
    EXPECT_LT(rates.norm(), 4 / description_.control.singularityDamping * twist.norm() + 20) << q.transpose();
  }
}

TEST_P(Resolution, StaysBoundedWhenPulledBeyondItsReach) {
  JointVector q = description_.homeAngles;
  Pose wanted = arm_.forward(q);
  for (int tick = 0; tick < 2000; ++tick) {
    wanted.position += kPeriod * Vector3(1, 0.3, 0.4);
    const ArmPose pose = arm_.evaluate(q);
    Vector6 twist = driftCorrection(wanted, pose.X_BT, 1);
    twist /= std::max(1., twist.norm());
    const JointVector rates = resolution_->rates(GetParam(), q, pose.J_BT, twist, kPeriod);
    ASSERT_TRUE(rates.allFinite());
    // A few times what the damping lets through of a twist of one; self-motion keeps within the rate limits.
    ASSERT_LT(rates.norm(), 6 / description_.control.singularityDamping + description_.drives.rateLimit.norm());
    q += kPeriod * rates.cwiseMin(description_.drives.rateLimit).cwiseMax(-description_.drives.rateLimit);
  }
  EXPECT_GT(arm_.forward(q).position.norm(), 0.9);
}

TEST(Resolution, OfAnArmThatIsNoVishard10IsFull) {
  DeviceDescription description = test::circleDevice();
  const RedundancyResolution both(description);
  EXPECT_TRUE(both.isPartitionable());
  description.chain = test::vishard10Chain(description.links);
  const RedundancyResolution resolution(description);
  EXPECT_FALSE(resolution.isPartitionable());
  const JointVector q = description.homeAngles;
  const Jacobian J = ArmKinematics(description).jacobian(q);
  const ResolutionChoice full{Strategy::dir, Solution::full}, partitioned{Strategy::dir, Solution::partitioned};
  const Vector6 twist = Vector6::Ones();
  EXPECT_EQ(resolution.rates(partitioned, q, J, twist, 0), resolution.rates(full, q, J, twist, 0));
  // The same arm by its closed forms and as a chain.
  EXPECT_LT((resolution.rates(full, q, J, twist, 0) - both.rates(full, q, J, twist, 0)).norm(), 1e-6);
}

/// Seven joints: three columns of J are zero, and so are those joints' rates.
TEST(Resolution, ServesAnyChain) {
  test::Random random(3);
  for (int i = 0; i < 20; ++i) {
    DeviceDescription description;
    description.chain = test::randomChain(random, 7);
    description.homeAngles.setConstant(0.5);
    const RedundancyResolution resolution(description);
    const JointVector q = random.vector<JointVector>(-3, 3);
    const Jacobian J = ArmKinematics(description).jacobian(q);
    const Vector6 twist = random.vector<Vector6>(-1, 1);
    for (const ResolutionChoice& choice : allChoices()) {
      const JointVector rates = resolution.rates(choice, q, J, twist, 0);
      EXPECT_TRUE(rates.allFinite());
      EXPECT_EQ(rates.tail<3>(), Eigen::Vector3d::Zero());
    }
  }
}

}  // namespace
}  // namespace haptiv
