#include "tests/support/usb/ShimTime.h"

#include <algorithm>
#include <atomic>
#include <ctime>
#include <limits>

namespace haptiv::test {

namespace {

std::atomic<bool> counts = false;
std::atomic<std::int64_t> total = 0;  // [ns]
std::atomic<std::int64_t> looks = 0;  // [ns] that an empty stretch takes beyond what it counts

std::int64_t threadTime() noexcept {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

}  // namespace

void ShimTime::count() noexcept {
  constexpr int kRounds = 10, kTimes = 2000;
  counts = true;
  looks = 0;
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (int round = 0; round < kRounds; ++round) {
    const std::int64_t before = total, start = threadTime();
    for (int i = 0; i < kTimes; ++i) ShimTime empty;
    least = std::min(least, (threadTime() - start - (total - before)) / kTimes);
  }
  looks = least;
}

double ShimTime::taken() noexcept {
  return 1e-9 * static_cast<double>(total);
}

ShimTime::ShimTime() noexcept {
  if (counts) start_ = threadTime();
}

ShimTime::~ShimTime() {
  if (start_ != 0) total += threadTime() - start_ + looks;
}

}  // namespace haptiv::test
