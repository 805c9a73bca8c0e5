#pragma once

#include "device/DeviceDescription.h"
#include "device/types.h"

namespace haptiv {

/// Joint rates of least norm that move the tool as wanted, eq. (3): qdot = J^T (J J^T + mu^2 I)^-1 xdot.
///
/// mu is zero away from singularities and grows towards control.singularityDamping near them, so that rates stay bounded.
/// @param J       6x10, in B
/// @param twist   wanted twist of the tool, in B [m/s, rad/s]
/// Realtime-safe: yes.  Never NaN for finite input.
JointVector leastNormRates(const Jacobian& J, const Vector6& twist, const ControlSettings& control) noexcept;

/// Twist that pulls the tool from `actual` back to `desired` within 1/gain seconds (closed-loop inverse kinematics).
/// Realtime-safe: yes.
Vector6 driftCorrection(const Pose& desired, const Pose& actual, double gain) noexcept;

}  // namespace haptiv
