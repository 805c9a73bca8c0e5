#pragma once

#include <functional>
#include <string>

#include "app/session/Session.h"

namespace haptiv {

/// What a session in real time came to.
struct LiveRun {
  SessionSummary summary;
  SessionTiming timing;
  std::string scheduling;  ///< how the servo thread ran, and what to do for better
  std::string logTrouble;  ///< empty: none
};

/// Leads the live hand of a session, a hundred times a second; gets its newest tick.
using LiveOperator = std::function<void(Session& session, const TickRecord& newest)>;

/// Runs a session in real time for `seconds`, or until Ctrl-C, SIGTERM, a fault of the arm or trouble with the log;
/// the log is closed in every case. Throws what Session throws.
/// Thread: main, before any other is started, for the signals are to come here.
LiveRun runLive(const SessionSetup& setup, double seconds, const LiveOperator& lead = {});

}  // namespace haptiv
