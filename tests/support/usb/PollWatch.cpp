#include "tests/support/usb/PollWatch.h"

#include <algorithm>

#include "tests/support/usb/ShimTime.h"
#include "tests/support/usb/UsbfsShim.h"

namespace haptiv::test {

PollWatch::Sleeper& PollWatch::of(std::thread::id thread) {
  const auto at = std::find_if(sleepers_.begin(), sleepers_.end(), [&](const auto& s) { return s.thread == thread; });
  if (at != sleepers_.end()) return *at;
  sleepers_.push_back({thread, false, {}});
  return sleepers_.back();
}

int PollWatch::poll(pollfd* descriptors, nfds_t count, int timeout) {
  fallsAsleep(descriptors, count);
  const int ready = realPoll(descriptors, count, timeout);
  wakesUp();
  return ready;
}

void PollWatch::fallsAsleep(const pollfd* descriptors, nfds_t count) {
  const ShimTime time;
  const std::lock_guard lock(mutex_);
  Sleeper& sleeper = of(std::this_thread::get_id());
  sleeper.awaits.assign(descriptors, descriptors + count);
  sleeper.asleep = true;
}

void PollWatch::wakesUp() {
  const ShimTime time;
  const std::lock_guard lock(mutex_);
  of(std::this_thread::get_id()).asleep = false;
}

bool PollWatch::quiet(const std::vector<int>& attended) const {
  const std::thread::id self = std::this_thread::get_id();
  const std::lock_guard lock(mutex_);
  const auto isAttended = [&](int descriptor) {
    return std::any_of(sleepers_.begin(), sleepers_.end(), [&](const Sleeper& sleeper) {
      return sleeper.asleep && std::any_of(sleeper.awaits.begin(), sleeper.awaits.end(), [&](const pollfd& awaited) {
               return std::max(awaited.fd, ~awaited.fd) == descriptor;
             });
    });
  };
  if (!std::all_of(attended.begin(), attended.end(), isAttended)) return false;
  return std::all_of(sleepers_.begin(), sleepers_.end(), [&](const Sleeper& sleeper) {
    if (sleeper.thread == self) return true;
    std::vector<pollfd> awaits = sleeper.awaits;
    return sleeper.asleep && realPoll(awaits.data(), awaits.size(), 0) == 0;
  });
}

void PollWatch::expect(std::thread::id thread) {
  const std::lock_guard lock(mutex_);
  of(thread);
}

void PollWatch::forget(std::thread::id thread) {
  const std::lock_guard lock(mutex_);
  std::erase_if(sleepers_, [&](const Sleeper& sleeper) { return sleeper.thread == thread; });
}

PollWatch& pollWatch() {
  static PollWatch& watch = *new PollWatch;  // never destroyed: umockdev's thread polls until the program has ended
  return watch;
}

}  // namespace haptiv::test
