#include "haptics/realtime/MonotonicClock.h"

#include <cerrno>
#include <ctime>

namespace haptiv {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

/// Tells the processor that this is a loop that waits: it saves power, and the other thread of the core goes faster.
void relax() noexcept {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

}  // namespace

std::int64_t monotonicNow() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * kSecond + now.tv_nsec;
}

void sleepUntil(std::int64_t deadline) noexcept {
  timespec until{};
  until.tv_sec = deadline / kSecond;
  until.tv_nsec = deadline % kSecond;
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

void sleepThenSpin(std::int64_t deadline, std::int64_t spin) noexcept {
  sleepUntil(deadline - spin);
  while (monotonicNow() < deadline) relax();
}

}  // namespace haptiv
