#pragma once

#include "device/redundancy/criterion/CriterionSlope.h"
#include "device/types.h"

namespace haptiv {

/// Gradients of the side criteria, in closed form: the criterion's slope K turns each block A of J into df/dA, and the
/// Jacobian's derivative turns that into df/dq.
/// @param squaredWeights  c_k^2 of the joints, eqs. (7), (8)
/// @param eigen           of the block's Gram matrix A diag(c^2) A^T
/// Realtime-safe: all of it.  Finite for finite input, at singular poses too.

/// Of the linear rows of J.
JointVector translationalGradient(Strategy strategy, const Jacobian& J, const JointVector& squaredWeights,
                                  const BlockEigen<3>& eigen, Corners corners) noexcept;
/// Of the angular rows of J.
JointVector rotationalGradient(Strategy strategy, const Jacobian& J, const JointVector& squaredWeights,
                               const BlockEigen<3>& eigen, Corners corners) noexcept;
/// Of J_xy, the four upright joints of eq. (24).
Eigen::Vector4d planarGradient(Strategy strategy, const Eigen::Matrix<double, 2, 4>& J_xy,
                               const Eigen::Vector4d& squaredWeights, const BlockEigen<2>& eigen,
                               Corners corners) noexcept;
/// Of J_rot, eq. (25).
Eigen::Vector4d wristGradient(Strategy strategy, const Eigen::Matrix<double, 3, 4>& J_rot,
                              const Eigen::Vector4d& squaredWeights, const BlockEigen<3>& eigen,
                              Corners corners) noexcept;

}  // namespace haptiv
