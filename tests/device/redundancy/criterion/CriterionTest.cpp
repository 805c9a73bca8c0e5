#include "device/redundancy/criterion/Criterion.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "device/kinematics/Vishard10.h"
#include "device/redundancy/criterion/CriterionGradient.h"
#include "device/redundancy/criterion/JacobianDerivative.h"
#include "tests/device/PaperArm.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

using std::numbers::pi;

TEST(Criterion, IsVolumeConditionAndTheirQuotient) {
  const Vector3 sigma(3, 2, 0.5);
  EXPECT_NEAR(ellipsoidVolume(sigma), 4 * pi / 3 * 3, 1e-14);
  EXPECT_NEAR(conditionNumber(sigma), 6, 1e-14);
  EXPECT_NEAR(directionalManipulability(sigma), ellipsoidVolume(sigma) / conditionNumber(sigma), 1e-14);
  const Eigen::Vector2d flat(3, 2);
  EXPECT_NEAR(ellipsoidVolume(flat), pi * 6, 1e-14);
  EXPECT_NEAR(directionalManipulability(flat), ellipsoidVolume(flat) / conditionNumber(flat), 1e-14);
}

TEST(Criterion, IsDefinedAtSingularPoses) {
  for (const Vector3& sigma : {Vector3(2, 1, 0), Vector3(2, 0, 0), Vector3(0, 0, 0)}) {
    EXPECT_EQ(ellipsoidVolume(sigma), 0);
    EXPECT_EQ(directionalManipulability(sigma), 0);
    EXPECT_EQ(conditionNumber(sigma), kLargestCondition);
  }
}

TEST(Dexterity, IsTheEllipsoidOfTheSingularValueDecomposition) {
  test::Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Jacobian J = kArm.jacobian(random.vector<JointVector>(-pi, pi));
    for (const bool turning : {false, true}) {
      const Dexterity dexterity = turning ? rotationalDexterity(J) : translationalDexterity(J);
      const Eigen::MatrixXd block = turning ? J.bottomRows<3>() : J.topRows<3>();
      const Eigen::JacobiSVD<Eigen::MatrixXd> svd(block, Eigen::ComputeThinU);
      // By way of the Gram matrix half of the digits of what is small are lost.
      EXPECT_LT((dexterity.sigma - svd.singularValues()).norm(), 1e-7);
      const Matrix3 gram = block * block.transpose();
      EXPECT_LT((gram * dexterity.axes - dexterity.axes * dexterity.sigma.cwiseAbs2().asDiagonal()).norm(), 1e-13);
    }
  }
}

/// What a gradient is tested on: a criterion of one block of J as a function of the joint angles.
struct Block {
  std::function<double(Strategy, const JointVector&, Corners)> value;
  std::function<JointVector(Strategy, const JointVector&, Corners)> gradient;
  std::function<Eigen::VectorXd(const JointVector&)> sigma;
  std::vector<int> joints;  ///< by which to differentiate
};

/// Three rows of J.
Block rowsOf(int first, const JointVector& squaredWeights) {
  const auto eigen = [=](const JointVector& q) {
    const JacobianBlock A = kArm.jacobian(q).middleRows<3>(first);
    return BlockEigen<3>(A * squaredWeights.asDiagonal() * A.transpose());
  };
  return {[=](Strategy s, const JointVector& q, Corners c) { return criterionValue<3>(s, eigen(q).sigma, c); },
          [=](Strategy s, const JointVector& q, Corners c) {
            const auto gradient = first == 0 ? translationalGradient : rotationalGradient;
            return gradient(s, kArm.jacobian(q), squaredWeights, eigen(q), c);
          },
          [=](const JointVector& q) { return Eigen::VectorXd(eigen(q).sigma); },
          {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}};
}

/// J_xy of the joints 1..4 alone, the others at zero; its gradient has four entries.
Block planar(const Eigen::Vector4d& squaredWeights) {
  const auto columns = [](const JointVector& q) -> Eigen::Matrix<double, 2, 4> {
    return kArm.jacobian(q).topLeftCorner<2, 4>();
  };
  const auto eigen = [=](const JointVector& q) {
    return BlockEigen<2>(columns(q) * squaredWeights.asDiagonal() * columns(q).transpose());
  };
  return {[=](Strategy s, const JointVector& q, Corners c) { return criterionValue<2>(s, eigen(q).sigma, c); },
          [=](Strategy s, const JointVector& q, Corners c) {
            JointVector gradient = JointVector::Zero();
            gradient.head<4>() = planarGradient(s, columns(q), squaredWeights, eigen(q), c);
            return gradient;
          },
          [=](const JointVector& q) { return Eigen::VectorXd(eigen(q).sigma); },
          {0, 1, 2, 3}};
}

/// J_rot of th5, th8, 9, 10 with the others at zero.
Block wrist(const Eigen::Vector4d& squaredWeights) {
  const auto columns = [](const JointVector& q) {
    const Jacobian J = kArm.jacobian(q);
    Eigen::Matrix<double, 3, 4> J_rot;
    J_rot << J.col(4).tail<3>(), J.col(7).tail<3>(), J.col(8).tail<3>(), J.col(9).tail<3>();
    return J_rot;
  };
  const auto eigen = [=](const JointVector& q) {
    return BlockEigen<3>(columns(q) * squaredWeights.asDiagonal() * columns(q).transpose());
  };
  return {[=](Strategy s, const JointVector& q, Corners c) { return criterionValue<3>(s, eigen(q).sigma, c); },
          [=](Strategy s, const JointVector& q, Corners c) {
            const auto four = wristGradient(s, columns(q), squaredWeights, eigen(q), c);
            JointVector gradient = JointVector::Zero();
            gradient << 0, 0, 0, 0, four[0], 0, 0, four[1], four[2], four[3];
            return gradient;
          },
          [=](const JointVector& q) { return Eigen::VectorXd(eigen(q).sigma); },
          {4, 7, 8, 9}};
}

/// Whether a block is away from its singularities and, for sharp corners, from those.
bool isSmooth(const Eigen::VectorXd& sigma, Corners corners) {
  if (sigma[sigma.size() - 1] < 0.02 * sigma[0]) return false;
  const double gap = (sigma.head(sigma.size() - 1) - sigma.tail(sigma.size() - 1)).minCoeff();
  return corners == Corners::rounded || gap > 1e-2 * sigma[0];
}

/// To 1e-6 of the gradient or of one: steps of 1e-5 rad leave (1e-5)^2 times third derivatives, which grow with the
/// cube of the condition number.
int holdAgainstDifferences(const Block& block, const std::function<JointVector(test::Random&)>& anyPose) {
  constexpr double kStep = 1e-5;
  test::Random random(2);
  int compared = 0;
  for (int i = 0; i < 60; ++i) {
    const JointVector q = anyPose(random);
    for (const Corners corners : {Corners::sharp, Corners::rounded}) {
      if (!isSmooth(block.sigma(q), corners)) continue;
      for (const Strategy strategy : {Strategy::nonopt, Strategy::man, Strategy::dir, Strategy::cond}) {
        const Eigen::VectorXd sigma = block.sigma(q);
        if (strategy == Strategy::cond && sigma[0] > 0.99 * kSteepestCondition * sigma[sigma.size() - 1]) continue;
        const JointVector gradient = block.gradient(strategy, q, corners);
        for (const int k : block.joints) {
          const JointVector step = kStep * JointVector::Unit(k);
          const double difference =
              (block.value(strategy, q + step, corners) - block.value(strategy, q - step, corners)) / (2 * kStep);
          EXPECT_NEAR(gradient[k], difference, 1e-6 * (1 + gradient.norm()))
              << "strategy " << static_cast<int>(strategy) << ", joint " << k + 1 << ", sigma "
              << block.sigma(q).transpose();
        }
      }
      ++compared;
    }
  }
  return compared;
}

JointVector anyAngles(test::Random& random) {
  return random.vector<JointVector>(-pi, pi);
}

TEST(CriterionGradient, OfTheFullBlocksIsWhatCentralDifferencesSay) {
  JointVector weighted;
  weighted << 0.4, 1, 1, 0.9, 1, 0.4, 0.5, 1, 0.8, 1;
  for (const JointVector& squaredWeights : {JointVector(JointVector::Ones()), weighted}) {
    for (const int first : {0, 3}) EXPECT_GT(holdAgainstDifferences(rowsOf(first, squaredWeights), anyAngles), 50);
  }
}

TEST(CriterionGradient, OfThePartitionedBlocksIsWhatCentralDifferencesSay) {
  const auto scara = [](test::Random& random) {
    JointVector q = JointVector::Zero();  // joints 6 and 7 upright: the wrist centre is where link 4 ends
    q.head<4>() = random.vector<Eigen::Vector4d>(-pi, pi);
    return q;
  };
  const auto handle = [](test::Random& random) {
    JointVector q = JointVector::Zero();
    q.tail<6>() = random.vector<Vector6>(-pi, pi);
    q[5] = q[6] = 0;
    return q;
  };
  const Eigen::Vector4d weighted(0.4, 1, 0.8, 0.6);
  for (const Eigen::Vector4d& squaredWeights : {Eigen::Vector4d(Eigen::Vector4d::Ones()), weighted}) {
    EXPECT_GT(holdAgainstDifferences(planar(squaredWeights), scara), 50);
    EXPECT_GT(holdAgainstDifferences(wrist(squaredWeights), handle), 50);
  }
}

/// From a pose with kappa 20 to a singular one: less and less, without a step.
TEST(CriterionGradient, OfTheConditionNumberVanishesTowardsASingularPose) {
  double before = -1;
  for (double smallest = 0.06; smallest > 0; smallest -= 1e-4) {
    const Vector3 squares(1, 0.3, smallest * smallest);
    const BlockEigen<3> eigen(Matrix3(squares.asDiagonal()));
    // How fast kappa falls with its smallest singular value: K times that value.
    const double slope = -smallest * criterionSlope<3>(Strategy::cond, eigen, Corners::sharp)(2, 2);
    if (before >= 0) {
      EXPECT_LT(std::abs(slope - before), 4);  // 400 at its steepest
      if (smallest < 0.0499) {
        EXPECT_LT(slope, before);
      }
    }
    before = slope;
  }
  EXPECT_LT(before, 1);
}

TEST(CriterionGradient, IsFiniteAtSingularPoses) {
  JointVector flatWrist = JointVector::Zero();  // axes 8 and 10 parallel, axes 5 and 9 too
  for (const Jacobian& J : {kArm.jacobian(JointVector::Zero()), kArm.jacobian(flatWrist), Jacobian(Jacobian::Zero())}) {
    const JacobianBlock v = J.topRows<3>(), w = J.bottomRows<3>();
    const JointVector one = JointVector::Ones();
    for (const Corners corners : {Corners::sharp, Corners::rounded}) {
      for (const Strategy strategy : {Strategy::man, Strategy::dir, Strategy::cond}) {
        EXPECT_TRUE(translationalGradient(strategy, J, one, BlockEigen<3>(v * v.transpose()), corners).allFinite());
        EXPECT_TRUE(rotationalGradient(strategy, J, one, BlockEigen<3>(w * w.transpose()), corners).allFinite());
      }
    }
  }
}

TEST(RoundedCorners, LeaveTheConditionNumberWhereSingularValuesAreApart) {
  const double bound = std::pow(3, 1. / 8);
  test::Random random(3);
  for (int i = 0; i < 300; ++i) {
    Vector3 sigma(1, random.between(0.01, 1), random.between(0.01, 1));
    if (sigma[1] < sigma[2]) std::swap(sigma[1], sigma[2]);
    const double ratio = criterionValue<3>(Strategy::cond, sigma, Corners::rounded) / conditionNumber(sigma);
    EXPECT_GE(ratio, 1 - 1e-15);
    EXPECT_LE(ratio, bound + 1e-15);
    if (sigma[1] < 0.5 && sigma[2] < 0.5 * sigma[1]) {
      EXPECT_LE(ratio, 1 + 1e-5);
    }
    EXPECT_NEAR(criterionValue<3>(Strategy::dir, sigma, Corners::rounded) * ratio, directionalManipulability(sigma),
                1e-14);
  }
}

}  // namespace
}  // namespace haptiv
