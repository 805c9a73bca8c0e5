#include "app/commands/session/LiveRun.h"

#include <algorithm>
#include <chrono>

#include "app/commands/HeldSignals.h"

namespace haptiv {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

LiveRun runLive(const SessionSetup& setup, double seconds, const LiveOperator& lead) {
  const std::chrono::nanoseconds look = std::chrono::milliseconds(lead ? 10 : 50);
  const HeldSignals held;
  Session session(setup);
  TickRecord record;
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  for (auto now = Clock::now(); now < end; now = Clock::now()) {
    if (held.pending(std::min<std::chrono::nanoseconds>(look, end - now))) break;
    const bool isNew = session.newest(record);
    if (isNew && lead) lead(session, record);
    if ((isNew && record.faults != kNoFault) || !session.logTrouble().empty()) break;
  }
  LiveRun run;
  run.scheduling = session.scheduling().explanation;
  run.summary = session.stop();
  run.timing = session.timing();
  run.logTrouble = session.logTrouble();
  return run;
}

}  // namespace haptiv
