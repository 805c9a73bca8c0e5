#include "app/commands/session/ReplayCommand.h"

#include <iostream>
#include <memory>

#include "app/commands/ExitCode.h"
#include "app/commands/NamedFile.h"
#include "app/commands/Report.h"
#include "app/commands/WindowCommand.h"
#include "app/commands/session/ChangedScenes.h"
#include "app/commands/session/SessionReport.h"
#include "app/session/Resimulation.h"
#include "app/session/log/reading/LogExport.h"
#include "app/session/log/reading/SessionLog.h"
#include "scenegraph/reading/SceneFile.h"

namespace haptiv {
namespace {

struct ReplayOptions {
  std::string log;
  bool verify = false;
  std::vector<std::string> changes;  // NODE.FIELD=VALUE
  std::string exported;              // CSV to be written; empty: none
  bool json = false;
};

// Adds what the verification found; false where there is a difference.
bool addVerification(Report& report, const SessionLog& log) {
  const Verification verification = verify(log);
  report.add("identical", verification.identical());
  report.add("ticks", verification.ticks);
  if (verification.identical()) {
    report.add("first_difference", nullptr);
    return true;
  }
  Report difference;
  difference.add("tick", verification.first->tick);
  difference.add("field", verification.first->field);
  difference.add("logged", verification.first->logged);
  difference.add("resimulated", verification.first->resimulated);
  report.addPart("first_difference", difference);
  return false;
}

// One side of a comparison.
Report reportOf(const SessionSummary& summary) {
  Report report;
  report.add("max_force_N", summary.maxForce);
  report.add("max_penetration_m", summary.maxPenetration);
  report.add("contacts", summary.contacts);
  report.add("final_desired_position_m", numbers(summary.last.desiredPosition));
  report.add("faults", faultNames(summary.last.faults));
  return report;
}

// Re-simulates with changed properties. The hand and the arm stay as logged: what differs is what the scene answers,
// and where the admittance would have sent the ball.
void addChanges(Report& report, const SessionLog& log, const std::vector<std::string>& texts) {
  std::vector<PropertyChange> changes;
  for (const std::string& text : texts) changes.push_back(parseChange(text));
  initSceneGraph();
  SessionSummary before, after;
  resimulate(log, withChanges(log.scenes(), changes), [&](const TickRecord& logged, const TickRecord& again) {
    before.take(logged);
    after.take(again);
    return true;
  });
  report.add("set", texts);
  report.addPart("logged", reportOf(before));
  report.addPart("changed", reportOf(after));
}

// Nothing was asked for but the log itself: the window shows it.
int showLog(int argc, char** argv, const ReplayOptions& options) {
  if (options.json)
    throw CommandFailure(kWrongUsage, "replay --json: the window prints nothing; add --verify, --set or --export");
  return openWindow(argc, argv, options.log);
}

int replayLog(int argc, char** argv, const ReplayOptions& options) {
  if (!options.verify && options.changes.empty() && options.exported.empty()) return showLog(argc, argv, options);

  requireReadable(options.log);
  const SessionLog log(options.log);
  if (!log.complete())
    std::cerr << "haptiv: " << options.log << ": the log was cut off; this is about the " << log.tickCount()
              << " ticks that are there\n";
  Report report;
  const bool identical = !options.verify || addVerification(report, log);
  if (!options.changes.empty()) addChanges(report, log, options.changes);
  if (!options.exported.empty()) {
    exportCsv(log, options.exported);
    report.add("export", options.exported);
  }
  report.print(options.json);
  return identical ? kGood : kNotSo;
}

}  // namespace

void addReplayCommand(const Command& program, int argc, char** argv) {
  const auto options = std::make_shared<ReplayOptions>();
  const Command replay = program.add("replay", "Replay a session log; in the window if nothing else is asked for",
                                     [=] { return replayLog(argc, argv, *options); });
  replay.path("LOG", options->log, "Session log (.h5)").required();
  replay.flag("--verify", options->verify, "Re-simulate, compare bit for bit, and name the first difference");
  replay.texts("--set", options->changes, "Re-simulate with this property changed; may be given several times")
      .type("NODE.FIELD=VALUE");
  replay.path("--export", options->exported, "Write the ticks as a table").type("FILE.csv");
  replay.json(options->json);
}

}  // namespace haptiv
