#pragma once

#include <algorithm>
#include <cmath>

#include "device/described/DeviceDescription.h"
#include "device/redundancy/matrices/Cholesky.h"
#include "device/redundancy/matrices/SymmetricEigen.h"

namespace haptiv {

/// Solves a redundant task t = A qdot, with A of Rows x Cols, Rows < Cols, and a weight c_k a joint: rates
/// qdot / c are of least norm, eqs. (3), (7), (8).
/// Realtime-safe: yes.  Never NaN for finite input.
template <int Rows, int Cols>
class PseudoInverse {
 public:
  using Matrix = Eigen::Matrix<double, Rows, Cols>;
  using Task = Eigen::Matrix<double, Rows, 1>;
  using Rates = Eigen::Matrix<double, Cols, 1>;
  using Gram = Eigen::Matrix<double, Rows, Rows>;

  PseudoInverse(const Matrix& A, const Rates& squaredWeights) noexcept : A_(A), squaredWeights_(squaredWeights) {
    weighted_ = A * squaredWeights.asDiagonal();
    gram_.noalias() = weighted_.lazyProduct(A.transpose());
    // Keeps the factors real at a singular pose, and is lost among the roundings of the largest entries elsewhere.
    Gram regular = gram_;
    regular.diagonal().array() += kRegularisation * gram_.trace() + kTiny;
    exact_ = Cholesky<Rows>(regular);
  }

  /// A diag(c^2) A^T.
  const Gram& gram() const noexcept { return gram_; }
  /// Product of the singular values of A diag(c), eq. (6).
  double manipulability() const noexcept { return exact_.rootOfDeterminant(); }

  /// From now on leastNorm is damped along singular vectors u_i with sigma_i < 2 `largest`, and along no others:
  /// 1 / sigma_i becomes sigma_i / (sigma_i^2 + mu_i^2) with mu_i = largest (1 - sigma_i / (2 largest)) closeness.
  /// So where the arm cannot turn about one axis, it still moves exactly in every other direction.
  /// @param closeness  to the singularity: 1 there, 0 where damping sets in; rates have no step then
  void damp(double largest, double closeness) noexcept {
    if (!(closeness > 0)) return;
    const SymmetricEigen<Rows> eigen(gram_);
    Task inverse;
    for (int i = 0; i < Rows; ++i) {
      const double square = std::max(eigen.values[i], 0.);
      const double mu = closeness * std::max(largest - std::sqrt(square) / 2, 0.);
      inverse[i] = 1 / (square + mu * mu + kTiny);
    }
    damped_.noalias() = eigen.vectors * inverse.asDiagonal() * eigen.vectors.transpose();
    isDamped_ = true;
  }

  Rates leastNorm(const Task& task) const noexcept {
    const Task multipliers = isDamped_ ? Task(damped_.lazyProduct(task)) : Task(exact_.solve(task));
    return weighted_.transpose().lazyProduct(multipliers);
  }

  /// The part of the gradient that leaves the task alone, eq. (4): N c^2 grad with A N = 0. Never damped.
  Rates nullSpacePart(const Rates& gradient) const noexcept {
    const Task pushed = weighted_.lazyProduct(gradient);
    const Task multipliers = exact_.solve(pushed);
    const Rates compensated = gradient - A_.transpose().lazyProduct(multipliers);
    return squaredWeights_.cwiseProduct(compensated);
  }

 private:
  static constexpr double kRegularisation = 1e-14;
  static constexpr double kTiny = 1e-300;

  Matrix A_, weighted_;
  Rates squaredWeights_;
  Gram gram_;
  Cholesky<Rows> exact_;
  Gram damped_;  ///< inverse, where isDamped_
  bool isDamped_ = false;
};

}  // namespace haptiv
