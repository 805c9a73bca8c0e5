#pragma once

#include <Eigen/Eigenvalues>
#include <numbers>

namespace haptiv {

/// V of the unit ball in `Rows` dimensions, pi^(m/2) / Gamma(1 + m/2)                    [paper, eq. (10)]
template <int Rows>
inline constexpr double kUnitBall = Rows == 2 ? std::numbers::pi : 4. / 3 * std::numbers::pi;

/// Singular values and left singular vectors of a block of J, from its Gram matrix J J^T.
/// Realtime-safe: yes.  Finite for finite input.
template <int Rows>
struct BlockEigen {
  explicit BlockEigen(const Eigen::Matrix<double, Rows, Rows>& gram) noexcept {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Rows, Rows>> solver(gram);
    // Rounding can leave an eigenvalue of a singular pose slightly negative.
    sigma = solver.eigenvalues().cwiseMax(0.).cwiseSqrt().reverse();
    axes = solver.eigenvectors().rowwise().reverse();
  }

  Eigen::Matrix<double, Rows, 1> sigma;    ///< falling
  Eigen::Matrix<double, Rows, Rows> axes;  ///< a column for each
};

}  // namespace haptiv
