#pragma once

#include "device/types.h"

namespace haptiv {

/// How the handle is to stand and turn.
struct RotationState {
  Matrix3 rotation = Matrix3::Identity();  ///< R_BT
  Vector3 rate = Vector3::Zero();          ///< in B [rad/s]
};

/// Rate after one step of I w' = tau_hand - b w, in B [rad/s]; b is taken at the step's end: stable for every one.
/// I is the same about every axis, so that there is no gyroscopic term.
/// @param torque   of the hand about the grip, in B [N m]
/// @param inertia  I [kg m^2]
/// @param damping  b [N m s/rad]
/// Realtime-safe: yes.
Vector3 nextRate(const RotationState& state, const Vector3& torque, double inertia, double damping, double dt) noexcept;

/// The rotation after it has turned by rate * dt about the axes of B: exp(rate dt) R. What rounding takes from its
/// orthogonality is given back. Realtime-safe: yes.
Matrix3 turned(const Matrix3& rotation, const Vector3& rate, double dt) noexcept;

}  // namespace haptiv
