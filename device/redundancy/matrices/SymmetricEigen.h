#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace haptiv {

/// Eigenvalues, rising, and unit eigenvectors of a symmetric matrix, of which the lower half is read.
/// Realtime-safe: yes.  Finite for finite input.
template <int N>
struct SymmetricEigen {
  explicit SymmetricEigen(const Eigen::Matrix<double, N, N>& matrix) noexcept {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> solver(matrix);
    values = solver.eigenvalues();
    vectors = solver.eigenvectors();
  }

  Eigen::Matrix<double, N, 1> values;
  Eigen::Matrix<double, N, N> vectors;  ///< a column for each
};

/// A matrix of one or two rows is tridiagonal as it is. Eigen's solver finds the same bits on a detour, by Householder
/// reflections of blocks, which take a compiler half a minute under the sanitizers.
template <>
struct SymmetricEigen<1> {
  explicit SymmetricEigen(const Eigen::Matrix<double, 1, 1>& matrix) noexcept : values(matrix) {}
  Eigen::Matrix<double, 1, 1> values;
  Eigen::Matrix<double, 1, 1> vectors = Eigen::Matrix<double, 1, 1>::Identity();
};
template <>
struct SymmetricEigen<2> {
  explicit SymmetricEigen(const Eigen::Matrix2d& matrix) noexcept {
    const double largest = std::max(std::abs(matrix(1, 0)), std::max(std::abs(matrix(0, 0)), std::abs(matrix(1, 1))));
    const double scale = largest == 0 ? 1 : largest;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
    solver.computeFromTridiagonal(Eigen::Vector2d(matrix(0, 0) / scale, matrix(1, 1) / scale),
                                  Eigen::Matrix<double, 1, 1>(matrix(1, 0) / scale));
    values = scale * solver.eigenvalues();
    vectors = solver.eigenvectors();
  }
  Eigen::Vector2d values;
  Eigen::Matrix2d vectors;
};

}  // namespace haptiv
