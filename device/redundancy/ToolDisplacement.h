#pragma once

#include "device/types.h"

namespace haptiv {

/// How far the tool goes when joints turn by `step` [rad]: translation [m] and rotation vector [rad], in B. Exact, as
/// forward kinematics is, but from J alone: column i is the screw of joint i's axis, seen from the tool, and the tool's
/// motion is the product of the exponentials exp(s_1 step_1) ... exp(s_n step_n).
/// For steps of a tick: a turn of theta comes out wrong by theta^5 / 10, which is 1e-11 rad for 0.01 rad.
/// Realtime-safe: yes.
Vector6 toolDisplacement(const Jacobian& J, const JointVector& step) noexcept;

}  // namespace haptiv
