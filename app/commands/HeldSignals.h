#pragma once

#include <chrono>
#include <csignal>
#include <ctime>

namespace haptiv {

/// Holds Ctrl-C and SIGTERM back, for all threads started meanwhile, so that `pending` can wait for them.
class HeldSignals {
 public:
  HeldSignals() {
    sigemptyset(&set_);
    sigaddset(&set_, SIGINT);
    sigaddset(&set_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &set_, &before_);
  }
  ~HeldSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  /// Waits this long for a signal; true as soon as one has come.
  bool pending(std::chrono::nanoseconds patience) const {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(patience);
    const timespec wait{static_cast<time_t>(seconds.count()), static_cast<long>((patience - seconds).count())};
    return sigtimedwait(&set_, nullptr, &wait) > 0;
  }

 private:
  sigset_t set_{};
  sigset_t before_{};
};

}  // namespace haptiv
