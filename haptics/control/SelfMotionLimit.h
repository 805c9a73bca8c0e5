#pragma once

#include "device/types.h"

namespace haptiv {

/// Keeps self-motion from starting and stopping faster than drives can follow. The criteria of the redundancy ask for
/// as much of it as the joints' rate limits leave (eqs. (17)-(20)); where a joint leaves its limit that can be radians
/// per second from one tick to the next.
///
/// What of the rates' change moves the tool passes whole; of the rest, which does not, no joint gets more than
/// kSpeedUp where self-motion becomes faster, or kSlowDown where it becomes slower: it must come to rest sooner than
/// it started, or it would overshoot what the criteria want, to and fro.
struct SelfMotionLimit {
  static constexpr double kSpeedUp = 50;    ///< [rad/s^2]
  static constexpr double kSlowDown = 100;  ///< [rad/s^2]

  /// @param wanted  rates of this tick [rad/s]
  /// @param before  those of the tick before
  /// @param J       where the arm is
  /// Realtime-safe: yes.
  static JointVector calmed(const JointVector& wanted, const JointVector& before, const Jacobian& J,
                            double period) noexcept;
};

}  // namespace haptiv
