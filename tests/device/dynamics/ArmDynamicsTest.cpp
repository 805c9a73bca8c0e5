#include "device/dynamics/ArmDynamics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <kdl/chaindynparam.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <numbers>

#include "tests/device/kinematics/Chains.h"
#include "tests/device/kinematics/ToKdl.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

/// An arm of seven joints in any directions, with bodies of any kind.
DeviceDescription anyArm() {
  test::Random random(4);
  DeviceDescription description;
  description.chain = test::randomChain(random, 7);
  description.bodies.gravity = random.vector<Vector3>(-5, 5);
  for (int i = 0; i < 7; ++i) {
    const Matrix3 R = test::randomPose(random).rotation;
    const Vector3 moments(0.03, 0.02 + random.between(0, 0.02), 0.03);
    description.bodies.links.push_back(
        {random.between(0.5, 4), random.vector<Vector3>(-0.3, 0.3), R * moments.asDiagonal() * R.transpose()});
  }
  return description;
}

class ArmDynamicsOf : public testing::TestWithParam<const char*> {
 protected:
  DeviceDescription description_ = std::string(GetParam()) == "AnyArm" ? anyArm() : loadDeviceDescription("vishard10");
  ArmDynamics dynamics_{description_};
  int count_ = description_.jointCount();
};
INSTANTIATE_TEST_SUITE_P(All, ArmDynamicsOf, testing::Values("Vishard10", "AnyArm"),
                         [](const auto& instance) { return std::string(instance.param); });

TEST_P(ArmDynamicsOf, IsThatOfOrocosKdl) {
  const KDL::Chain chain = test::toKdl(chainOfArm(description_), description_.bodies, description_.drives.inertia);
  const KDL::Vector gravity = test::toKdl(description_.bodies.gravity);
  KDL::ChainDynParam parameters(chain, gravity);
  KDL::ChainIdSolver_RNE inverse(chain, gravity);
  const KDL::Wrenches none(chain.getNrOfSegments(), KDL::Wrench::Zero());
  KDL::JntArray q(count_), qd(count_), qdd(count_), torques(count_);
  KDL::JntSpaceInertiaMatrix M(count_);
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const JointVector angles = randomAngles(random), rates = random.vector<JointVector>(-6, 6),
                      accelerations = random.vector<JointVector>(-50, 50);
    q.data = angles.head(count_);
    qd.data = rates.head(count_);
    qdd.data = accelerations.head(count_);
    ASSERT_GE(inverse.CartToJnt(q, qd, qdd, none, torques), 0);
    ASSERT_GE(parameters.JntToMass(q, M), 0);
    // Torques of some hundred N m: 1e-9 of them is what a thousand roundings may do.
    ASSERT_LT((dynamics_.inverse(angles, rates, accelerations).head(count_) - torques.data).cwiseAbs().maxCoeff(),
              1e-9);
    ASSERT_LT((dynamics_.massMatrix(angles).topLeftCorner(count_, count_) - M.data).cwiseAbs().maxCoeff(), 1e-9);
    ASSERT_GE(parameters.JntToGravity(q, torques), 0);
    ASSERT_LT((dynamics_.gravity(angles).head(count_) - torques.data).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST_P(ArmDynamicsOf, MassMatrixIsSymmetricAndPositiveDefinite) {
  test::Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const JointMatrix M = dynamics_.massMatrix(randomAngles(random));
    EXPECT_EQ(M, M.transpose());
    EXPECT_EQ(M.llt().info(), Eigen::Success);
  }
}

TEST_P(ArmDynamicsOf, EquationIsMassMatrixAndBias) {
  test::Random random(3);
  const JointVector q = randomAngles(random), qd = random.vector<JointVector>(-6, 6);
  EXPECT_EQ(dynamics_.evaluate(q, qd).mass, dynamics_.massMatrix(q));
  EXPECT_EQ(dynamics_.evaluate(q, qd).bias, dynamics_.bias(q, qd));
}

TEST_P(ArmDynamicsOf, GravityIsTheSlopeOfThePotentialEnergy) {
  constexpr double kStep = 1e-5;
  test::Random random(5);
  for (int i = 0; i < 200; ++i) {
    const JointVector q = randomAngles(random), g = dynamics_.gravity(q);
    for (int joint = 0; joint < kJointCount; ++joint) {
      const JointVector ahead = kStep * JointVector::Unit(joint);
      const double slope = (dynamics_.potentialEnergy(q + ahead) - dynamics_.potentialEnergy(q - ahead)) / (2 * kStep);
      EXPECT_NEAR(g[joint], slope, 1e-7);  // differences of some 100 J, rounded, over 2e-5
    }
  }
}

TEST_P(ArmDynamicsOf, ForwardDynamicsIsTheInverseOfInverseDynamics) {
  test::Random random(6);
  const ArmKinematics arm(description_);
  for (int i = 0; i < 500; ++i) {
    const JointVector q = randomAngles(random), qd = random.vector<JointVector>(-6, 6);
    JointVector qdd = random.vector<JointVector>(-50, 50);
    qdd.tail(kJointCount - count_).setZero();
    const Wrench onTool{random.vector<Vector3>(-100, 100), random.vector<Vector3>(-10, 10)};
    Vector6 wrench;
    wrench << onTool.force, onTool.torque;
    const JointVector torques = dynamics_.inverse(q, qd, qdd) - arm.jacobian(q).transpose() * wrench;
    EXPECT_LT((dynamics_.accelerations(q, qd, torques, onTool) - qdd).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST_P(ArmDynamicsOf, KeepsItsEnergyInFreeFall) {
  const auto energy = [&](const JointVector& q, const JointVector& qd) {
    return 0.5 * qd.dot(dynamics_.massMatrix(q) * qd) + dynamics_.potentialEnergy(q);
  };
  const auto falling = [&](const JointVector& q, const JointVector& qd) {
    return dynamics_.accelerations(q, qd, JointVector::Zero(), {});
  };
  JointVector q = description_.homeAngles, qd = JointVector::Zero();
  const double before = energy(q, qd);
  constexpr double dt = 1e-4;
  double fastest = 0;
  for (int i = 0; i < 10000; ++i) {  // one second by the classical method of Runge and Kutta
    const JointVector a1 = falling(q, qd);
    const JointVector v2 = qd + dt / 2 * a1, a2 = falling(q + dt / 2 * qd, v2);
    const JointVector v3 = qd + dt / 2 * a2, a3 = falling(q + dt / 2 * v2, v3);
    const JointVector v4 = qd + dt * a3, a4 = falling(q + dt * v3, v4);
    q += dt / 6 * (qd + 2 * v2 + 2 * v3 + v4);
    qd += dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    fastest = std::max(fastest, qd.norm());
  }
  EXPECT_GT(fastest, 1);
  EXPECT_NEAR(energy(q, qd), before, 1e-7);  // tens of joules went to and fro; the method is of fourth order
}

TEST(ArmDynamics, Vishard10MovesTwentyThreeKilogrammesWhoseWeightJointsSixAndSevenCarry) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  double mass = 0;
  for (const LinkBody& link : description.bodies.links) mass += link.mass;
  EXPECT_NEAR(mass, 23, 1e-9);
  const ArmDynamics dynamics(description);
  test::Random random(7);
  JointVector largest = JointVector::Zero();
  for (int i = 0; i < 2000; ++i) largest = largest.cwiseMax(dynamics.gravity(randomAngles(random)).cwiseAbs());
  EXPECT_LT(largest.head<5>().maxCoeff(), 1e-9);  // their axes are vertical
  EXPECT_GT(largest.segment<2>(5).minCoeff(), 5);
  EXPECT_LT(largest.tail<3>().maxCoeff(), 3);
}

TEST(ArmDynamics, SaysWhatIsMissingOfAnArmWithoutBodies) {
  DeviceDescription bare = loadDeviceDescription("anthropomorphic7");
  bare.bodies.links.clear();
  try {
    ArmDynamics{bare};
    FAIL() << "nothing is known of its links";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(),
                testing::AllOf(testing::HasSubstr("anthropomorphic7"), testing::HasSubstr("bodies.link")));
  }
}

}  // namespace
}  // namespace haptiv
