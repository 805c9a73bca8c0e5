#include "device/kinematics/Vishard10.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace haptiv {

namespace {

constexpr double kPi = std::numbers::pi;

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

/// What pose and Jacobian are made of.
struct Parts {
  Parts(const LinkLengths& links, const JointVector& q) noexcept
      : swing6(links.lift * std::sin(q[5])),
        swing7(links.lift * std::sin(q[5] + q[6])),
        rise6(links.lift * std::cos(q[5])),
        rise7(links.lift * std::cos(q[5] + q[6])) {
    double heading = 0;
    for (int i = 0; i < 5; ++i) {
      heading += q[i];
      along[i] = Vector3(std::cos(heading), std::sin(heading), 0);
    }
    R_B8.col(0) = along[4];
    R_B8.col(1) = Vector3(-along[4].y(), along[4].x(), 0);
    R_B8.col(2) = Vector3::UnitZ();
    R_B8 = R_B8 * aboutX(wristTilt(q));
  }

  std::array<Vector3, 5> along;         // (cos fi, sin fi, 0)
  double swing6, swing7, rise6, rise7;  // of links 6 and 7: across x of link 5, and up [m]
  Matrix3 R_B8;                         // Rz(f5) Rx(th8*)
};

Pose poseOf(const LinkLengths& links, const Parts& parts, const JointVector& q) noexcept {
  Pose X_BT;
  for (int i = 0; i < 4; ++i) X_BT.position += links.scara * parts.along[i];
  const Vector3& along5 = parts.along[4];
  X_BT.position += (parts.swing6 + parts.swing7) * Vector3(along5.y(), -along5.x(), 0);
  X_BT.position.z() = parts.rise6 + parts.rise7;
  X_BT.rotation = parts.R_B8 * aboutZ(q[8]) * aboutX(q[9]);
  return X_BT;
}

Jacobian jacobianOf(const LinkLengths& links, const Parts& parts, const JointVector& q) noexcept {
  const Vector3& along5 = parts.along[4];
  const Vector3 across5(along5.y(), -along5.x(), 0);
  const auto lifted = [&](double rise, double swing) { return Vector3(rise * across5 - swing * Vector3::UnitZ()); };

  Jacobian J = Jacobian::Zero();
  auto linear = J.topRows<3>();
  linear.col(4) = (parts.swing6 + parts.swing7) * along5;
  for (int i = 3; i >= 0; --i) {  // joint i moves what joint i+1 moves, and link i
    linear.col(i) = linear.col(i + 1) + links.scara * Vector3(-parts.along[i].y(), parts.along[i].x(), 0);
  }
  linear.col(5) = lifted(parts.rise6 + parts.rise7, parts.swing6 + parts.swing7);
  linear.col(6) = lifted(parts.rise7, parts.swing7);

  auto angular = J.bottomRows<3>();
  angular.leftCols<5>().row(2).setOnes();
  angular.middleCols<3>(5).colwise() = along5;
  angular.col(8) = parts.R_B8.col(2);
  angular.col(9) = parts.R_B8 * Vector3(std::cos(q[8]), std::sin(q[8]), 0);
  return J;
}

}  // namespace

Pose Vishard10::forward(const JointVector& q) const noexcept {
  return poseOf(links_, Parts(links_, q), q);
}

Jacobian Vishard10::jacobian(const JointVector& q) const noexcept {
  return jacobianOf(links_, Parts(links_, q), q);
}

ArmPose Vishard10::evaluate(const JointVector& q) const noexcept {
  const Parts parts(links_, q);
  return {poseOf(links_, parts, q), jacobianOf(links_, parts, q)};
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

ArmSkeleton Vishard10::skeleton(const JointVector& q) const noexcept {
  const Parts parts(links_, q);
  const Vector3 across5(parts.along[4].y(), -parts.along[4].x(), 0);
  ArmSkeleton skeleton;
  skeleton.count = 10;
  auto& at = skeleton.at;
  at[0] = Vector3(0, 0, links_.scaraHeight);
  for (int i = 0; i < 4; ++i) at[i + 1] = at[i] + links_.scara * parts.along[i];
  at[5] = at[4] + links_.forearm * parts.along[4];
  at[6] = at[5] - links_.scaraHeight * Vector3::UnitZ();
  at[7] = at[6] + parts.swing6 * across5 + parts.rise6 * Vector3::UnitZ();
  at[8] = at[7] + parts.swing7 * across5 + parts.rise7 * Vector3::UnitZ();
  at[9] = at[8] - links_.forearm * parts.along[4];
  return skeleton;
}

}  // namespace haptiv
