#pragma once

#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// The virtual mass's motion: what the device is to follow.
struct AdmittanceState {
  Vector3 position = Vector3::Zero();  ///< in W [m]
  Vector3 velocity = Vector3::Zero();  ///< in W [m/s]
};

/// Velocity after one semi-implicit step of M xdd = f_hand - f_r  [paper, eq. (29)], in W [m/s].
/// `force` is f_hand - f_r [N]. The position follows once the joints have said how much of it they can do.
/// Realtime-safe: yes.
Vector3 nextVelocity(const AdmittanceState& state, const Vector3& force, double mass, double dt) noexcept;

}  // namespace haptiv
