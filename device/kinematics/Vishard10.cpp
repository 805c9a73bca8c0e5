#include "device/kinematics/Vishard10.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace haptiv {

namespace {

constexpr double kPi = std::numbers::pi;

/// f1..f5, with fi = th1+..+thi: headings of the links in the plane [rad].
std::array<double, 5> headings(const JointVector& q) noexcept {
  std::array<double, 5> f{};
  double sum = 0;
  for (int i = 0; i < 5; ++i) f[i] = sum += q[i];
  return f;
}

Matrix3 aboutX(double angle) noexcept {
  return Eigen::AngleAxisd(angle, Vector3::UnitX()).toRotationMatrix();
}
Matrix3 aboutZ(double angle) noexcept {
  return Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix();
}

/// th8*, the tilt of joint 9's axis  [paper, eq. (25)].
double wristTilt(const JointVector& q) noexcept {
  return q[5] + q[6] + q[7];
}

/// acos of a coordinate over its reach; what lies beyond is clamped to it.
double reachAngle(double coordinate, double reach) noexcept {
  return std::acos(std::clamp(coordinate / reach, -1., 1.));
}

}  // namespace

Pose Vishard10::forward(const JointVector& q) const noexcept {
  const auto f = headings(q);
  Pose X_BT;
  for (int i = 0; i < 4; ++i) X_BT.position += links_.scara * Vector3(std::cos(f[i]), std::sin(f[i]), 0);
  const double swing = links_.lift * (std::sin(q[5]) + std::sin(q[5] + q[6]));
  X_BT.position += swing * Vector3(std::sin(f[4]), -std::cos(f[4]), 0);
  X_BT.position.z() = links_.lift * (std::cos(q[5]) + std::cos(q[5] + q[6]));
  X_BT.rotation = aboutZ(f[4]) * aboutX(wristTilt(q)) * aboutZ(q[8]) * aboutX(q[9]);
  return X_BT;
}

Jacobian Vishard10::jacobian(const JointVector& q) const noexcept {
  const auto f = headings(q);
  const double c = std::cos(f[4]);
  const double s = std::sin(f[4]);
  const double sin6 = links_.lift * std::sin(q[5]), sin7 = links_.lift * std::sin(q[5] + q[6]);
  const double cos6 = links_.lift * std::cos(q[5]), cos7 = links_.lift * std::cos(q[5] + q[6]);

  Jacobian J = Jacobian::Zero();
  auto linear = J.topRows<3>();
  linear.col(4) = (sin6 + sin7) * Vector3(c, s, 0);
  for (int i = 3; i >= 0; --i) {  // joint i moves what joint i+1 moves, and link i
    linear.col(i) = linear.col(i + 1) + links_.scara * Vector3(-std::sin(f[i]), std::cos(f[i]), 0);
  }
  linear.col(5) = Vector3((cos6 + cos7) * s, -(cos6 + cos7) * c, -(sin6 + sin7));
  linear.col(6) = Vector3(cos7 * s, -cos7 * c, -sin7);

  auto angular = J.bottomRows<3>();
  const Matrix3 R_B8 = aboutZ(f[4]) * aboutX(wristTilt(q));
  angular.leftCols<5>().row(2).setOnes();
  angular.middleCols<3>(5).colwise() = Vector3(c, s, 0);
  angular.col(8) = R_B8.col(2);
  angular.col(9) = R_B8 * Vector3(std::cos(q[8]), std::sin(q[8]), 0);
  return J;
}

JointVector Vishard10::inverse(const Vector3& p_BT, const JointVector& like) const noexcept {
  const double a = reachAngle(p_BT.y(), 2 * links_.scara);
  const double b = reachAngle(p_BT.x(), 2 * links_.scara);
  JointVector q = like;
  q[0] = a - 1.5 * kPi;  // links 1 and 2 give y
  q[1] = 2 * kPi - 2 * a;
  q[2] = b - q[0] - q[1];  // links 3 and 4 give x
  q[3] = 2 * kPi - 2 * b;
  q[4] = like.head<5>().sum() - q.head<4>().sum();  // keeps th5*
  q[5] = reachAngle(p_BT.z(), 2 * links_.lift);     // joints 6 and 7 as a prismatic joint
  q[6] = -2 * q[5];
  q[7] = wristTilt(like) - q[5] - q[6];  // keeps th8*
  return q;
}

std::array<Vector3, 10> Vishard10::skeleton(const JointVector& q) const noexcept {
  const auto f = headings(q);
  const Matrix3 R_B5 = aboutZ(f[4]);
  std::array<Vector3, 10> at;
  at[0] = Vector3(0, 0, links_.scaraHeight);
  for (int i = 0; i < 4; ++i) at[i + 1] = at[i] + links_.scara * Vector3(std::cos(f[i]), std::sin(f[i]), 0);
  at[5] = at[4] + links_.forearm * R_B5.col(0);
  at[6] = at[5] - links_.scaraHeight * Vector3::UnitZ();
  at[7] = at[6] + links_.lift * (R_B5 * aboutX(q[5])).col(2);
  at[8] = at[7] + links_.lift * (R_B5 * aboutX(q[5] + q[6])).col(2);
  at[9] = at[8] - links_.forearm * R_B5.col(0);
  return at;
}

}  // namespace haptiv
