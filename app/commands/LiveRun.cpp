#include "app/commands/LiveRun.h"

#include <algorithm>
#include <chrono>

#include "app/commands/HeldSignals.h"

namespace haptiv {
namespace {

using Clock = std::chrono::steady_clock;

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
  run.timing = session.timing();
  run.logTrouble = session.logTrouble();
  return run;
}

}  // namespace haptiv
