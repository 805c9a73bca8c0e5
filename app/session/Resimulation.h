#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/session/log/reading/SessionLog.h"

namespace haptiv {

/// Where a re-simulated session first differs from the logged one.
struct Difference {
  std::uint64_t tick = 0;
  std::string field;  ///< such as "desired_position_x_m"
  double logged = 0;
  double resimulated = 0;
};

struct Verification {
  std::uint64_t ticks = 0;  ///< compared
  std::optional<Difference> first;
  bool identical() const { return !first.has_value(); }
};

/// Gets a logged tick and the same one re-simulated; returns false to end.
using ResimulationSink = std::function<bool(const TickRecord& logged, const TickRecord& again)>;

/// Runs the logged readings through HapticTick again, with `scenes` in place of those of the log: the logged tick's
/// version picks one of them. The hand and the arm do not react to what is changed: their readings are those of the
/// log. Throws std::runtime_error where a scene is missing, or the log cannot be read or its device description not be
/// used; and where the log is of format 1, or a flight record that starts in the middle of a session.
void resimulate(const SessionLog& log, const std::vector<LoggedScene>& scenes, const ResimulationSink& sink);

/// Runs the logged inputs through the same tick again and compares every result bit for bit.
///
/// Ticks that never reached the log end the comparison: what came after them cannot be computed. The difference is then
/// in the field "dropped_records", with how many ticks had been run (logged) and how many are in the log (resimulated).
Verification verify(const SessionLog& log);

}  // namespace haptiv
