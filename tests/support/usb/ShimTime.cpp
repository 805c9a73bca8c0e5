#include "tests/support/usb/ShimTime.h"

#include <atomic>
#include <ctime>

namespace haptiv::test {

namespace {

std::atomic<bool> counts = false;
std::atomic<std::int64_t> total = 0;  // [ns]

std::int64_t threadTime() noexcept {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

}  // namespace

void ShimTime::count() noexcept {
  counts = true;
}

double ShimTime::taken() noexcept {
  return 1e-9 * static_cast<double>(total);
}

ShimTime::ShimTime() noexcept {
  if (counts) start_ = threadTime();
}

ShimTime::~ShimTime() {
  if (start_ != 0) total += threadTime() - start_;
}

}  // namespace haptiv::test
