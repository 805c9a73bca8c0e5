#include "haptics/realtime/MonotonicClock.h"

#include <cerrno>
#include <ctime>

namespace haptiv {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

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

}  // namespace haptiv
