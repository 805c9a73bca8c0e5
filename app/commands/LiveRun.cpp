#include "app/commands/LiveRun.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <ctime>

namespace haptiv {
namespace {

using Clock = std::chrono::steady_clock;

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

bool faulty(Session& session) {
  TickRecord record;
  return session.newest(record) && record.faults != kNoFault;
}

}  // namespace

LiveRun runLive(const SessionSetup& setup, double seconds) {
  constexpr std::chrono::nanoseconds kLook = std::chrono::milliseconds(50);
  const HeldSignals signals;
  Session session(setup);
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  for (auto now = Clock::now(); now < end; now = Clock::now()) {
    if (signals.pending(std::min<std::chrono::nanoseconds>(kLook, end - now))) break;
    if (faulty(session) || !session.logTrouble().empty()) break;
  }
  LiveRun run;
  run.scheduling = session.scheduling().explanation;
  run.summary = session.stop();
  run.logTrouble = session.logTrouble();
  return run;
}

}  // namespace haptiv
