#pragma once

#include "device/DeviceDescription.h"
#include "device/types.h"

namespace haptiv {

/// Joint rates of least norm that move the tool as wanted, eq. (3): qdot = J^T (J J^T + mu^2 I)^-1 xdot.
///
/// mu is zero while the manipulability w = sqrt(det(J J^T)), eq. (6), is at least control.singularityThreshold; below
/// that mu = singularityDamping (1 - w / singularityThreshold), so that rates stay bounded and have no step.
/// w mixes metres and radians: the threshold belongs to the arm, so it stands in its description.
///
/// @param J       6x10, in B
/// @param twist   wanted twist of the tool, in B [m/s, rad/s]
/// Realtime-safe: yes.  Never NaN for finite input.
JointVector leastNormRates(const Jacobian& J, const Vector6& twist, const ControlSettings& control) noexcept;

}  // namespace haptiv
