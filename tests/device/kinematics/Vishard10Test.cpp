#include "device/kinematics/Vishard10.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <cmath>
#include <numbers>

#include "device/described/DeviceDescription.h"
#include "tests/device/PaperArm.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

using std::numbers::pi;

const LinkLengths kLinks;

TEST(Vishard10, IsStretchedAlongXAtZeroAngles) {
  const Pose X_BT = kArm.forward(JointVector::Zero());
  EXPECT_TRUE(X_BT.position.isApprox(Vector3(4 * 0.25, 0, 0.424), kRounding));
  EXPECT_EQ(X_BT.rotation, Matrix3::Identity());
}

/// Walks the chain of the reference's table link by link, links 5 and 8 included.
Pose walkTheChain(const JointVector& q) {
  const Vector3 x = Vector3::UnitX(), z = Vector3::UnitZ();
  const Vector3 axes[] = {z, z, z, z, z, x, x, x, z, x};
  const Vector3 moves[] = {0.25 * x,  0.25 * x,  0.25 * x,  0.25 * x,        0.47 * x,
                           0.212 * z, 0.212 * z, -0.47 * x, Vector3::Zero(), Vector3::Zero()};
  Pose pose;
  for (int i = 0; i < kJointCount; ++i) {
    pose.rotation = pose.rotation * Eigen::AngleAxisd(q[i], axes[i]).toRotationMatrix();
    pose.position += pose.rotation * moves[i];
  }
  return pose;
}

TEST(Vishard10, AgreesWithTheChainOfItsLinks) {
  test::Random random(1);
  for (int i = 0; i < 200; ++i) {
    const JointVector q = randomAngles(random);
    const Pose closed = kArm.forward(q);
    const Pose walked = walkTheChain(q);
    EXPECT_LT((closed.position - walked.position).norm(), kRounding);
    EXPECT_LT((closed.rotation - walked.rotation).norm(), kRounding);
  }
}

TEST(Vishard10, InverseFunctionPutsTheWristCentreWhereAskedAndKeepsTheOrientation) {
  test::Random random(2);
  for (int i = 0; i < 500; ++i) {
    const JointVector like = randomAngles(random);
    const Vector3 p(random.between(-0.5, 0.5), random.between(-0.5, 0.5), random.between(-0.424, 0.424));
    const Pose X_BT = kArm.forward(kArm.inverse(p, like));
    EXPECT_LT((X_BT.position - p).norm(), kRounding);
    EXPECT_LT((X_BT.rotation - kArm.forward(like).rotation).norm(), kRounding);
  }
}

TEST(Vishard10, InverseFunctionMeetsThePapersAngles) {
  const Vector3 p(0.3, -0.2, 0.1);
  const JointVector q = kArm.inverse(p, JointVector::Zero());
  const double a = std::acos(p.y() / 0.5), b = std::acos(p.x() / 0.5);
  EXPECT_NEAR(q[0], a - 1.5 * pi, kRounding);
  EXPECT_NEAR(q[1], -2 * a + 2 * pi, kRounding);
  EXPECT_NEAR(q[2], b - q[0] - q[1], kRounding);
  EXPECT_NEAR(q[3], -2 * b + 2 * pi, kRounding);
  EXPECT_NEAR(q[5], std::acos(p.z() / 0.424), kRounding);
  EXPECT_NEAR(q[6], -2 * q[5], kRounding);
}

TEST(Vishard10, InverseFunctionClampsWhatIsOutOfReach) {
  const JointVector q = kArm.inverse({3, -4, 5}, JointVector::Zero());
  ASSERT_TRUE(q.allFinite());
  EXPECT_LT((kArm.forward(q).position - Vector3(0.5, -0.5, 0.424)).norm(), kRounding);
}

/// Twist by central differences; their error is about step^2 plus rounding / step.
Vector6 differenceTwist(const JointVector& q, int joint, double step) {
  JointVector ahead = q, behind = q;
  ahead[joint] += step;
  behind[joint] -= step;
  const Pose a = kArm.forward(ahead), b = kArm.forward(behind);
  const Eigen::AngleAxisd turn(Matrix3(a.rotation * b.rotation.transpose()));
  Vector6 twist;
  twist << a.position - b.position, turn.angle() * turn.axis();
  return twist / (2 * step);
}

TEST(Vishard10, JacobianIsTheDerivativeOfThePose) {
  test::Random random(3);
  for (int i = 0; i < 100; ++i) {
    const JointVector q = randomAngles(random);
    const Jacobian J = kArm.jacobian(q);
    for (int joint = 0; joint < kJointCount; ++joint) {
      EXPECT_LT((J.col(joint) - differenceTwist(q, joint, 1e-5)).norm(), 1e-8) << "joint " << joint + 1;
    }
  }
}

TEST(Vishard10, RotationalBlockDependsOnTheWristAlone) {
  test::Random random(4);
  for (int i = 0; i < 100; ++i) {
    const JointVector q = randomAngles(random);
    JointVector other = randomAngles(random);
    other[4] += q.head<5>().sum() - other.head<5>().sum();          // same th5*
    other[7] += q.segment<3>(5).sum() - other.segment<3>(5).sum();  // same th8*
    other.tail<2>() = q.tail<2>();
    EXPECT_LT((kArm.jacobian(q) - kArm.jacobian(other)).bottomRows<3>().norm(), kRounding);
  }
}

TEST(Vishard10, SelfMotionLeavesTheToolStill) {
  test::Random random(5);
  for (int i = 0; i < 100; ++i) {
    const JointVector q = randomAngles(random);
    const Eigen::JacobiSVD<Jacobian, Eigen::FullPivHouseholderQRPreconditioner> svd(kArm.jacobian(q),
                                                                                    Eigen::ComputeFullV);
    const JointVector direction = svd.matrixV().rightCols<4>() * random.vector<Eigen::Vector4d>(-1, 1);
    constexpr double kStep = 1e-5;  // second order remains: about step^2 times the arm's curvature
    const Pose before = kArm.forward(q), after = kArm.forward(q + kStep * direction);
    EXPECT_LT((after.position - before.position).norm(), 1e-9);
    EXPECT_LT((after.rotation - before.rotation).norm(), 1e-9);
  }
}

TEST(Vishard10, SkeletonEndsInTheWristCentreAndHasTheLinksLengths) {
  test::Random random(6);
  const double lengths[] = {0.25, 0.25, 0.25, 0.25, 0.47, 0.71, 0.212, 0.212, 0.47};
  for (int i = 0; i < 50; ++i) {
    const JointVector q = randomAngles(random);
    const auto [places, count] = kArm.skeleton(q);
    ASSERT_EQ(count, 10);
    EXPECT_EQ(places[0], Vector3(0, 0, 0.71));
    EXPECT_LT((places[9] - kArm.forward(q).position).norm(), kRounding);
    for (int link = 0; link < 9; ++link) {
      EXPECT_NEAR((places[link + 1] - places[link]).norm(), lengths[link], kRounding);
    }
  }
}

TEST(Vishard10, StandsLevelAndRegularAtTheHomeOfItsDescription) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const JointVector& home = description.homeAngles;
  const Vishard10 arm(description.links);
  EXPECT_LT((arm.forward(home).position - Vector3(0.35, 0, 0)).norm(), kRounding);
  EXPECT_LT((arm.forward(home).rotation - Matrix3::Identity()).norm(), kRounding);
  EXPECT_LT((arm.inverse({0.35, 0, 0}, home) - home).norm(), kRounding);
  const Eigen::Matrix<double, 3, 10> J_rot = arm.jacobian(home).bottomRows<3>();
  const Matrix3 gram = J_rot * J_rot.transpose();
  EXPECT_GT(std::sqrt(Eigen::SelfAdjointEigenSolver<Matrix3>(gram).eigenvalues()[0]),
            0.9);  // 1 where axes are perpendicular
}

}  // namespace
}  // namespace haptiv
