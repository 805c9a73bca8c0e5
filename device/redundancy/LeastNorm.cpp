#include "device/redundancy/LeastNorm.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace haptiv {

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// mu^2 = mu_max^2 (1 - w/w0)^2 below the threshold w0, zero above: once differentiable, so rates have no step.
double squaredDamping(double manipulability, const ControlSettings& control) noexcept {
  const double closeness = std::max(0., 1 - manipulability / control.singularityThreshold);
  const double mu = control.singularityDamping * closeness;
  return mu * mu;
}

}  // namespace

JointVector leastNormRates(const Jacobian& J, const Vector6& twist, const ControlSettings& control) noexcept {
  Matrix6 gram = J * J.transpose();
  Eigen::LDLT<Matrix6> factors(gram);
  // Rounding can leave a pivot of a singular pose slightly negative.
  const double manipulability = std::sqrt(factors.vectorD().cwiseMax(0.).prod());
  const double damping = squaredDamping(manipulability, control);
  if (damping > 0) {
    gram.diagonal().array() += damping;
    factors.compute(gram);
  }
  return J.transpose() * factors.solve(twist);
}

}  // namespace haptiv
