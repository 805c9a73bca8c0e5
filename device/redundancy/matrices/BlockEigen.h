#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "device/redundancy/matrices/SymmetricEigen.h"

namespace haptiv {

/// V of the unit ball in `Rows` dimensions, pi^(m/2) / Gamma(1 + m/2)                    [paper, eq. (10)]
template <int Rows>
inline constexpr double kUnitBall = Rows == 2 ? std::numbers::pi : 4. / 3 * std::numbers::pi;

/// Singular values and left singular vectors of a block of J, from its Gram matrix J J^T.
/// Realtime-safe: yes.  Finite for finite input.
template <int Rows>
struct BlockEigen {
  explicit BlockEigen(const Eigen::Matrix<double, Rows, Rows>& gram) noexcept {
    const SymmetricEigen<Rows> eigen(gram);
    for (int i = 0; i < Rows; ++i) {
      // Rounding can leave an eigenvalue of a singular pose slightly negative.
      sigma[i] = std::sqrt(std::max(eigen.values[Rows - 1 - i], 0.));
      axes.col(i) = eigen.vectors.col(Rows - 1 - i);
    }
  }

  Eigen::Matrix<double, Rows, 1> sigma;    ///< falling
  Eigen::Matrix<double, Rows, Rows> axes;  ///< a column for each
};

}  // namespace haptiv
