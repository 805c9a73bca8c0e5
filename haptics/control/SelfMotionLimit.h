#pragma once

#include "device/types.h"

namespace haptiv {

/// Keeps self-motion from starting and stopping faster than drives can follow. The criteria of the redundancy ask for
/// as much of it as the joints' rate limits leave (eqs. (17)-(20)); where a joint leaves its limit that can be radians
/// per second from one tick to the next.
///
/// What of the rates' change moves the tool passes whole; of the rest, which does not, no joint gets more than
/// kMostSelfMotion. Realtime-safe: yes.
/// @param wanted  rates of this tick [rad/s]
/// @param before  those of the tick before
/// @param J       where the arm is
JointVector withCalmSelfMotion(const JointVector& wanted, const JointVector& before, const Jacobian& J,
                               double period) noexcept;

inline constexpr double kMostSelfMotion = 60;  ///< [rad/s^2]

}  // namespace haptiv
