#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace haptiv {

/// The rates at which people are served [Hz]. Below, walls chatter; above, a tick has no time left. Tests and
/// simulations without a person may choose lower ones.
inline constexpr double kLowestServoRate = 500;
inline constexpr double kHighestServoRate = 8000;

/// How the servo waits for its next deadline: it sleeps until shortly before, and then looks at the clock until it is
/// there; a sleep alone ends tens of microseconds late.
struct ServoPace {
  double rate = 1000;                                             ///< [Hz]
  std::chrono::nanoseconds spin = std::chrono::microseconds(50);  ///< awake before the deadline; 0: sleeps all of it

  /// The spin that is done [ns]: a quarter of the period at most, for Linux stops a real-time thread that never
  /// sleeps for 50 ms in every second.
  std::int64_t spinNs() const noexcept {
    return std::clamp<std::int64_t>(spin.count(), 0, static_cast<std::int64_t>(1e9 / rate / 4));
  }
};

/// Records that the ring of a session holds: 6 s of ticks, so that a log writer can stall for 5 s with nothing lost.
inline std::size_t recordsToHold(double rate) {
  constexpr double kSeconds = 6;
  constexpr double kLeast = 4096;
  return static_cast<std::size_t>(std::max(kLeast, std::ceil(kSeconds * rate)));
}

}  // namespace haptiv
