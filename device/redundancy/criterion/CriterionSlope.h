#pragma once

#include <cmath>

#include "device/redundancy/criterion/Criterion.h"
#include "device/redundancy/matrices/BlockEigen.h"

namespace haptiv {

/// Where two singular values meet, the largest and the smallest one, and so kappa, have a corner, across which
/// gradient steps would jump to and fro; and often just there is the optimum. Rounded, kappa is the condition number
/// in the Schatten norm of order 16, (sum s_i^16)^(1/16) (sum s_i^-16)^(1/16): smooth, never below kappa, above it by
/// a factor of m^(1/8) at most, and by less than 1e-5 where all values are apart by a factor of two.
enum class Corners { sharp, rounded };

/// kappa grows without bound towards a singular pose, and its gradient with kappa^2. Beyond this kappa the gradient
/// falls again, in proportion to the smallest singular value: as if kappa went on as (3 - sm^2 / s^2) / 2 times this,
/// with s the sm at which it is reached. Steps of a tick stay short of overshooting, and nothing is made of rounding.
inline constexpr double kSteepestCondition = 20;

inline double power16(double x) noexcept {
  const double x2 = x * x, x4 = x2 * x2, x8 = x4 * x4;
  return x8 * x8;
}

/// kappa, and of which singular values it is made: d ln kappa = sum (top_i - bottom_i) ds_i / s_i.
template <int Rows>
struct Condition {
  using Values = Eigen::Array<double, Rows, 1>;

  /// @param s  falling, greater than zero
  Condition(const Values& s, Corners corners) noexcept : kappa(s[0] / s[Rows - 1]) {
    if (corners == Corners::sharp) {
      top[0] = bottom[Rows - 1] = 1;
      return;
    }
    for (int i = 0; i < Rows; ++i) {
      top[i] = power16(s[i] / s[0]);
      bottom[i] = power16(s[Rows - 1] / s[i]);
    }
    const double above = top.sum() * bottom.sum();
    kappa *= std::sqrt(std::sqrt(std::sqrt(std::sqrt(above))));
    top /= top.sum();
    bottom /= bottom.sum();
  }

  double kappa;
  Values top = Values::Zero(), bottom = Values::Zero();
};

/// Value of a side criterion for a block of J with singular values sigma, falling: V, V / kappa or kappa; zero for
/// nonopt. Dexterous is large, but for cond small.
template <int Rows>
double criterionValue(Strategy strategy, const Eigen::Matrix<double, Rows, 1>& sigma, Corners corners) noexcept {
  if (strategy == Strategy::man) return ellipsoidVolume(sigma);
  if (corners == Corners::sharp) {
    if (strategy == Strategy::dir) return directionalManipulability(sigma);
    return strategy == Strategy::cond ? conditionNumber(sigma) : 0;
  }
  if (strategy == Strategy::nonopt || !(sigma[0] > 0)) return 0;
  const double kappa = Condition<Rows>(sigma.array().max(sigma[0] / kLargestCondition), corners).kappa;
  return strategy == Strategy::cond ? kappa : ellipsoidVolume(sigma) / kappa;
}

/// The symmetric K with which the criterion's derivative by its block A of J is K A.
///
/// With df/ds_i = f_i and ds_i = u_i^T dA v_i, df/dA = sum f_i u_i v_i^T, and v_i^T = u_i^T A / s_i; so
/// K = U diag(f_i / s_i) U^T, and no right singular vector is needed. Where the pose is singular, s_1 /
/// kLargestCondition stands for what is less, and for kappa s_1 / kSteepestCondition: finite everywhere.
template <int Rows>
Eigen::Matrix<double, Rows, Rows> criterionSlope(Strategy strategy, const BlockEigen<Rows>& block,
                                                 Corners corners) noexcept {
  using Values = Eigen::Array<double, Rows, 1>;
  const double largest = block.sigma[0];
  if (!(largest > 0)) return Eigen::Matrix<double, Rows, Rows>::Zero();
  const double least = largest / (strategy == Strategy::cond ? kSteepestCondition : kLargestCondition);
  const Values s = block.sigma.array().max(least);
  const Condition<Rows> condition(s, corners);
  const Values kappaSlope = condition.top - condition.bottom;  // s d ln kappa / ds
  const double volume = kUnitBall<Rows> * s.prod();
  Values slope = Values::Zero();  // s df/ds
  if (strategy == Strategy::man) slope = volume;
  if (strategy == Strategy::dir) slope = volume / condition.kappa * (1 - kappaSlope);
  if (strategy == Strategy::cond) slope = condition.kappa * kappaSlope;
  return block.axes * (slope / s.square()).matrix().asDiagonal() * block.axes.transpose();
}

}  // namespace haptiv
