#pragma once

#include <algorithm>
#include <cstdint>

#include "haptics/safety/Faults.h"

namespace haptiv {

/// What is remembered of missed ticks.
struct MissedTickState {
  std::uint32_t missed = 0;  ///< in all
  double spent = 0;          ///< of the budget [s]
};

/// How long the servo may be away: a burst of `safety.missedTime`, or as much of every second in the long run.
///
/// A bucket: what is missed fills it, and it leaks by missedTime a second; full, the budget is spent. That the arm
/// stops while the servo is away is the work of the device's own watchdog.
class MissedTickBudget {
 public:
  MissedTickBudget(double missedTime, double period) : budget_(missedTime), period_(period) {}

  /// @param missed  grid points that the servo has skipped so far
  /// @return        kFaultMissedTicks, or none
  /// Realtime-safe: yes.
  std::uint32_t operator()(std::uint32_t missed, MissedTickState& state) const noexcept {
    const double away = period_ * static_cast<double>(missed - state.missed);
    state.missed = missed;
    state.spent = std::max(0.0, state.spent - budget_ * (period_ + away)) + away;
    const bool spentAll = state.spent > budget_;
    if (spentAll) state.spent = 0;  // told once; what follows is counted anew
    return spentAll ? kFaultMissedTicks : kNoFault;
  }

 private:
  double budget_, period_;
};

}  // namespace haptiv
