#pragma once

#include "device/types.h"

namespace haptiv {

/// Twist, in B, that pulls the tool from `actual` back to `desired` with time constant 1/gain [s] (closed-loop inverse
/// kinematics): gain times the position error and the rotation vector of R_desired R_actual^T, right up to half a turn.
/// Realtime-safe: yes.
Vector6 driftCorrection(const Pose& desired, const Pose& actual, double gain) noexcept;

}  // namespace haptiv
