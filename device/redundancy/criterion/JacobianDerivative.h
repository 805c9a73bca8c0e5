#pragma once

#include <Eigen/Geometry>

#include "device/types.h"

namespace haptiv {

/// How the Jacobian of a chain of revolute joints changes with its joint angles, from J alone. With v_i and w_i the
/// linear and the angular column i:
///   dv_i/dq_k = w_k x v_i for k <= i, w_i x v_k for k > i;   dw_i/dq_k = w_k x w_i for k < i, 0 else.
/// Whatever is a function of J is differentiated by the chain rule in one pass over the columns.
/// Realtime-safe: all of it.

/// The upper or lower three rows of J.
using JacobianBlock = Eigen::Matrix<double, 3, kJointCount>;

/// dJ/dq_k.
Jacobian jacobianDerivative(const Jacobian& J, int k) noexcept;

/// (dJ/dt) qdot: how the tool accelerates in B while the joints turn at constant rates [m/s^2, rad/s^2].
Vector6 toolAcceleration(const Jacobian& J, const JointVector& rates) noexcept;

/// df/dq of an f that depends on the linear rows of J, with P = df/dv.
JointVector gradientByLinearRows(const Jacobian& J, const JacobianBlock& P) noexcept;

/// df/dq of an f that depends on the angular columns w of a chain, with P = df/dw: 3 rows, a column each joint.
template <typename Columns>
Eigen::Matrix<double, Columns::ColsAtCompileTime, 1> gradientByAngularRows(
    const Columns& w, const Eigen::Matrix<double, 3, Columns::ColsAtCompileTime>& P) noexcept {
  Eigen::Matrix<double, Columns::ColsAtCompileTime, 1> gradient;
  Vector3 beyond = Vector3::Zero();  // sum of w_i x P_i over i > k
  for (Eigen::Index k = w.cols() - 1; k >= 0; --k) {
    const Vector3 w_k = w.col(k);
    gradient[k] = w_k.dot(beyond);
    beyond += w_k.cross(P.col(k));
  }
  return gradient;
}

}  // namespace haptiv
