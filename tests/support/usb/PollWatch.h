#pragma once

#include <poll.h>

#include <mutex>
#include <thread>
#include <vector>

namespace haptiv::test {

/// Knows which threads sleep in poll and for what, so that a test with a clock of its own can tell when everything that
/// its last step set off has been done. Thread: any.
class PollWatch {
 public:
  /// A poll that is watched.
  int poll(pollfd* descriptors, nfds_t count, int timeout);
  /// Every thread that has ever slept in poll, but the caller, sleeps there now, with nothing to wake it; and each of
  /// these descriptors is waited for by one, or passed over by it for now (its complement).
  bool quiet(const std::vector<int>& attended) const;
  /// A thread has been started that will sleep in poll: nothing is quiet before it does.
  void expect(std::thread::id thread);
  /// The calling thread ends.
  void forget(std::thread::id thread);

 private:
  struct Sleeper {
    std::thread::id thread;
    bool asleep = false;
    std::vector<pollfd> awaits;
  };
  Sleeper& of(std::thread::id thread);
  void fallsAsleep(const pollfd* descriptors, nfds_t count);
  void wakesUp();

  mutable std::mutex mutex_;
  std::vector<Sleeper> sleepers_;
};

/// The polls of the whole program.
PollWatch& pollWatch();

}  // namespace haptiv::test
