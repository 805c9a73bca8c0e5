#include "device/kinematics/PoseSearch.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>

#include "device/kinematics/ArmKinematics.h"

namespace haptiv {
namespace {

constexpr int kMostSearchSteps = 500;
constexpr double kFound = 1e-12;           // [m, rad]
constexpr double kLongestJointStep = 0.3;  // [rad] of any joint
constexpr double kLeastDamping = 1e-9, kFirstDamping = 1e-3, kMostDamping = 1e3;

Vector6 errorOf(const Pose& wanted, const Pose& actual) noexcept {
  const Eigen::AngleAxisd turn(Matrix3(wanted.rotation * actual.rotation.transpose()));
  Vector6 error;
  error << wanted.position - actual.position, turn.angle() * turn.axis();
  return error;
}

/// dq = J^T (J J^T + damping I)^-1 e, shortened so that no joint moves further than kLongestJointStep.
JointVector step(const Jacobian& J, const Vector6& error, double damping) noexcept {
  Eigen::Matrix<double, 6, 6> gram = J * J.transpose();
  gram.diagonal().array() += damping;
  const JointVector dq = J.transpose() * gram.ldlt().solve(error);
  return dq * (kLongestJointStep / std::max(dq.cwiseAbs().maxCoeff(), kLongestJointStep));
}

}  // namespace

JointVector searchPose(const ArmKinematics& arm, const Pose& X_BT, const JointVector& start) noexcept {
  JointVector best = start;
  double damping = kFirstDamping;
  ArmPose at = arm.evaluate(best);
  Vector6 error = errorOf(X_BT, at.X_BT);
  for (int i = 0; i < kMostSearchSteps && error.norm() > kFound && damping <= kMostDamping; ++i) {
    const JointVector next = best + step(at.J_BT, error, damping);
    const ArmPose there = arm.evaluate(next);
    const Vector6 remains = errorOf(X_BT, there.X_BT);
    if (!(remains.norm() < error.norm())) {  // Levenberg-Marquardt: shorter steps, straighter down
      damping *= 4;
      continue;
    }
    best = next;
    at = there;
    error = remains;
    damping = std::max(damping / 4, kLeastDamping);
  }
  return best;
}

}  // namespace haptiv
