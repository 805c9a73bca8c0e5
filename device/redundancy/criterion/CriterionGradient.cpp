#include "device/redundancy/criterion/CriterionGradient.h"

#include "device/redundancy/criterion/JacobianDerivative.h"

namespace haptiv {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) noexcept {
  return a.x() * b.y() - a.y() * b.x();
}

/// df/dq of an f of J_xy, with P = df/dJ_xy: as gradientByLinearRows, all axes upright.
Eigen::Vector4d gradientByPlanarRows(const Eigen::Matrix<double, 2, 4>& J_xy,
                                     const Eigen::Matrix<double, 2, 4>& P) noexcept {
  Eigen::Vector4d gradient;
  Eigen::Vector2d before = Eigen::Vector2d::Zero();  // sum of P_i over i < k
  for (int k = 0; k < 4; ++k) {
    gradient[k] = cross(J_xy.col(k), before);
    before += P.col(k);
  }
  double from = 0;  // sum of v_i x P_i over i >= k
  for (int k = 3; k >= 0; --k) {
    from += cross(J_xy.col(k), P.col(k));
    gradient[k] += from;
  }
  return gradient;
}

}  // namespace

JointVector translationalGradient(Strategy strategy, const Jacobian& J, const JointVector& squaredWeights,
                                  const BlockEigen<3>& eigen, Corners corners) noexcept {
  const Matrix3 K = criterionSlope(strategy, eigen, corners);
  return gradientByLinearRows(J, K.lazyProduct(J.topRows<3>()) * squaredWeights.asDiagonal());
}

JointVector rotationalGradient(Strategy strategy, const Jacobian& J, const JointVector& squaredWeights,
                               const BlockEigen<3>& eigen, Corners corners) noexcept {
  const Matrix3 K = criterionSlope(strategy, eigen, corners);
  const JacobianBlock P = K.lazyProduct(J.bottomRows<3>()) * squaredWeights.asDiagonal();
  return gradientByAngularRows(J.bottomRows<3>(), P);
}

Eigen::Vector4d planarGradient(Strategy strategy, const Eigen::Matrix<double, 2, 4>& J_xy,
                               const Eigen::Vector4d& squaredWeights, const BlockEigen<2>& eigen,
                               Corners corners) noexcept {
  const Eigen::Matrix2d K = criterionSlope(strategy, eigen, corners);
  return gradientByPlanarRows(J_xy, K.lazyProduct(J_xy) * squaredWeights.asDiagonal());
}

Eigen::Vector4d wristGradient(Strategy strategy, const Eigen::Matrix<double, 3, 4>& J_rot,
                              const Eigen::Vector4d& squaredWeights, const BlockEigen<3>& eigen,
                              Corners corners) noexcept {
  const Matrix3 K = criterionSlope(strategy, eigen, corners);
  const Eigen::Matrix<double, 3, 4> P = K.lazyProduct(J_rot) * squaredWeights.asDiagonal();
  return gradientByAngularRows(J_rot, P);
}

}  // namespace haptiv
