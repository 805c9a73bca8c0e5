#include "haptics/control/ReachLimit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace haptiv {
namespace {

constexpr double kStep = 1e-3;     // [rad] by which the joints are turned to see how m changes
constexpr double kRegular = 1e-9;  // [m^2] keeps the inverse finite at the border

using PlaceJacobian = Eigen::Matrix<double, 3, kJointCount>;

PlaceJacobian placeJacobian(const ArmPose& arm) noexcept {
  return arm.J_BT.topRows<3>();
}

/// (J J^T)^-1
Matrix3 effort(const PlaceJacobian& J) noexcept {
  Matrix3 gram = J.lazyProduct(J.transpose());
  gram.diagonal().array() += kRegular;
  return gram.inverse();
}

}  // namespace

ReachLimit::ReachLimit(const DeviceDescription& description) : arm_(description) {
  const Matrix3 atHome = effort(placeJacobian(arm_.evaluate(description.homeAngles)));
  const double least = 1 / std::sqrt(Eigen::SelfAdjointEigenSolver<Matrix3>(atHome).eigenvalues()[2]);
  stop_ = kStop * least;
  near_ = kNear * least;
}

Vector3 ReachLimit::operator()(const JointVector& q, const ArmPose& arm, const Vector3& velocity) const noexcept {
  const PlaceJacobian J = placeJacobian(arm);
  const Matrix3 E = effort(J);
  const Vector3 costly = E * velocity;
  const double length = costly.norm();
  if (!(length > 0)) return velocity;
  const Vector3 n = costly / length;
  const double m = 1 / std::sqrt(n.dot(E * n));
  if (!(m < near_)) return velocity;

  const JointVector turned = q + kStep * m * (J.transpose() * (E * n));
  const double further = 1 / std::sqrt(n.dot(effort(placeJacobian(arm_.evaluate(turned))) * n));
  const double perMetre = (m - further) / (kStep * m);
  if (!(perMetre > 0)) return velocity;  // inwards
  const double most = kRate * std::max(0.0, m - stop_) / ((1 - m / near_) * perMetre);
  return velocity - std::max(0.0, velocity.dot(n) - most) * n;
}

}  // namespace haptiv
