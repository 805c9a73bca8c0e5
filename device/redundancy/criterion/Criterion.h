#pragma once

#include "device/control/ResolutionChoice.h"
#include "device/types.h"

namespace haptiv {

/// Largest condition number that is told apart from a singular pose's.
inline constexpr double kLargestCondition = 1e6;

/// Volume of the manipulability ellipsoid, V = pi^(m/2) / Gamma(1 + m/2) s1 ... sm        [paper, eq. (10)]
/// @param sigma  singular values, falling; m = 2 or 3 of them
double ellipsoidVolume(const Eigen::Vector2d& sigma) noexcept;
double ellipsoidVolume(const Vector3& sigma) noexcept;

/// kappa = s1 / sm, at least 1; kLargestCondition where the pose is singular              [paper, eq. (11)]
double conditionNumber(const Eigen::Vector2d& sigma) noexcept;
double conditionNumber(const Vector3& sigma) noexcept;

/// m = V / kappa, written without a division: zero where the pose is singular             [paper, eqs. (12), (14)]
double directionalManipulability(const Eigen::Vector2d& sigma) noexcept;
double directionalManipulability(const Vector3& sigma) noexcept;

/// How well the tool can be moved in translation, or in rotation: the manipulability ellipsoid of a 3x10 block of J.
struct Dexterity {
  Vector3 sigma = Vector3::Zero();     ///< half axes, falling [m] or [1]: speed of the tool per unit joint rate
  Matrix3 axes = Matrix3::Identity();  ///< their directions in B, as columns
  double volume() const noexcept { return ellipsoidVolume(sigma); }
  double condition() const noexcept { return conditionNumber(sigma); }
  double directional() const noexcept { return directionalManipulability(sigma); }
};

/// Of J's rows 0..2, with equal weights of the joints. Singular values below 1e-8 of the largest are rounding.
/// Realtime-safe: yes.
Dexterity translationalDexterity(const Jacobian& J) noexcept;
/// Of J's rows 3..5.
Dexterity rotationalDexterity(const Jacobian& J) noexcept;

}  // namespace haptiv
