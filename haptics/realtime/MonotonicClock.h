#pragma once

#include <cstdint>

namespace haptiv {

/// CLOCK_MONOTONIC now [ns]. Realtime-safe: yes (no system call on Linux's vdso).
std::int64_t monotonicNow() noexcept;

/// Sleeps until CLOCK_MONOTONIC reaches `deadline` [ns]; returns at once where it has passed. Never spins.
void sleepUntil(std::int64_t deadline) noexcept;

/// Sleeps until `spin` [ns] before the deadline, and looks at the clock until it is there.
void sleepThenSpin(std::int64_t deadline, std::int64_t spin) noexcept;

}  // namespace haptiv
