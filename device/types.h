#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

/// Quantities that every layer shares. SI units throughout: m, rad, s, N, N m, kg.
///
/// Frames, written as monograms (p_WT: position of T's origin, in W; R_WT: turns T's axes into W's):
///   W  the scene's world, z up, one unit is one metre
///   B  the device's base: on the axis of joint 1, at the height of joint 6
///   T  the tool: origin in the wrist centre, where the operator grips; axes of the handle and its sensor
namespace haptiv {

inline constexpr int kJointCount = 10;

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using JointVector = Eigen::Matrix<double, kJointCount, 1>;
/// Maps joint rates [rad/s] to a twist: rows 0..2 linear [m/s], rows 3..5 angular [rad/s].
using Jacobian = Eigen::Matrix<double, 6, kJointCount>;

/// Position [m] and orientation of one frame in another; which ones, the variable's name says.
struct Pose {
  Vector3 position = Vector3::Zero();
  Matrix3 rotation = Matrix3::Identity();
};

/// Linear [m/s] and angular [rad/s] velocity.
struct Twist {
  Vector3 linear = Vector3::Zero();
  Vector3 angular = Vector3::Zero();
};

/// Force [N] and torque [N m].
struct Wrench {
  Vector3 force = Vector3::Zero();
  Vector3 torque = Vector3::Zero();
};

}  // namespace haptiv
