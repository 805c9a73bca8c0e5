#pragma once

#include "app/commands/Report.h"
#include "app/session/Session.h"
#include "haptics/tick/TickRecord.h"

namespace haptiv {

/// Session time after this tick [s].
double sessionSeconds(const TickRecord& last, double rate);

/// How the redundancy is resolved: strategy and solution by name.
void addResolution(Report& report, const ResolutionChoice& choice);

/// How punctual the servo was: how late it woke and how long its ticks took.
void addTiming(Report& report, const SessionTiming& timing);

/// How the arm is driven: display, joint controller, orientation and passivity control by name.
void addControl(Report& report, const ControlChoice& choice);

/// What a session came to, as `haptiv run` tells it.
Report reportOf(const SessionSummary& summary, double rate);

}  // namespace haptiv
