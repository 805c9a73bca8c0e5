#pragma once

#include "device/types.h"

namespace haptiv {

/// A damper f = -b v in the way of the tool, for one tick.
struct AddedDamping {
  double damping = 0;               ///< b [N s/m]
  Vector3 force = Vector3::Zero();  ///< in W [N]
};

/// Time-domain passivity controller, causality of an admittance: the damper that takes the missing energy out of the
/// virtual mass in the coming tick, and no more.
///
///   v' = s v,  (1 - s^2) m v^2 / 2 = missing,  b = (1/s - 1) m / dt,  f = -b v'
/// The damper acts on the velocity that comes out, so it stops the mass at most, and never turns it round.
/// @param missing   energy below zero [J]; where it is not positive, nothing is added
/// @param velocity  v, which the mass will have without the damper, in W [m/s]
/// @param most      longest force [N]; what it cannot take now is left for later ticks
/// Realtime-safe: yes.
AddedDamping dampMass(double missing, const Vector3& velocity, double mass, double period, double most) noexcept;

/// The same, causality of an impedance: f = -b v on the tool,  b = missing / (v^2 dt)
///
/// b is a quarter of m / dt at most: of a damper that is felt a tick late, a stronger one shakes the mass.
/// @param velocity  of the tool, measured, in W [m/s]
/// @param mass      of the arm at the tool, where it is lightest [kg]
/// Realtime-safe: yes.
AddedDamping dampTool(double missing, const Vector3& velocity, double mass, double period, double most) noexcept;

}  // namespace haptiv
