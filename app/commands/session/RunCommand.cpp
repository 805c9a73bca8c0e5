#include "app/commands/session/RunCommand.h"

#include <memory>
#include <optional>

#include "app/commands/ExitCode.h"
#include "app/commands/NamedFile.h"
#include "app/commands/Picture.h"
#include "app/commands/scene/LoadedScene.h"
#include "app/commands/session/LiveRun.h"
#include "app/commands/session/RunOptions.h"
#include "app/commands/session/RunPeople.h"
#include "app/commands/session/RunSetup.h"
#include "app/commands/session/SessionPicture.h"
#include "app/commands/session/SessionReport.h"
#include "app/session/Session.h"
#include "app/session/choices/SceneControl.h"
#include "app/session/choices/SceneResolution.h"

namespace haptiv {
namespace {

// What came of a session that could be run, though not everything asked for beside it may have succeeded.
struct Outcome {
  SessionSummary summary;
  std::string scheduling;               // empty: --fast
  std::optional<SessionTiming> timing;  // nothing: --fast
  std::string trouble;                  // with log or picture; empty: none
};

Outcome run(const RunOptions& options, const SessionSetup& setup) {
  const double seconds = lengthOf(options, setup);
  if (options.fast) return {runFast(setup, seconds), {}, {}, {}};
  LiveRun live = runLive(setup, seconds, operatorOf(options.hand, setup));
  return {std::move(live.summary), std::move(live.scheduling), std::move(live.timing), std::move(live.logTrouble)};
}

Report reportOf(const RunOptions& options, const SessionSetup& setup, const Outcome& outcome) {
  Report report = reportOf(outcome.summary, options.rate);
  addResolution(report, resolutionOf(*setup.scene, setup.description));
  addControl(report, controlOf(*setup.scene, setup.description));
  if (!outcome.scheduling.empty()) report.add("scheduling", outcome.scheduling);
  if (outcome.timing) addTiming(report, *outcome.timing);
  if (!options.log.empty()) report.add("log", options.log);
  if (!options.picture.empty()) report.add("picture", options.picture);
  return report;
}

std::string whereToLook(const SessionSummary& summary) {
  return summary.flights.empty() ? "see docs/safety.md" : "what led to it: " + summary.flights.back().string();
}

int runSession(const RunOptions& options) {
  refuseContradictions(options);
  initSceneGraph();
  const LoadedScene loaded = loadScene(options.scene, {options.solid, options.rate});
  tell(loaded.diagnostics);
  if (hasErrors(loaded.diagnostics))
    throw CommandFailure(kNotSo, options.scene + ": the scene has errors; mend the lines named above");
  const SessionSetup setup = setUp(options, loaded);
  if (!options.picture.empty()) requireWritable(options.picture);

  Outcome outcome = run(options, setup);
  if (!options.picture.empty()) {
    try {
      savePicture(drawSession(loaded, outcome.summary.last), options.picture);
    } catch (const std::exception& error) {  // the session's figures are told all the same
      outcome.trouble += (outcome.trouble.empty() ? "" : "\n") + std::string(error.what());
    }
  }
  reportOf(options, setup, outcome).print(options.json);
  if (!outcome.trouble.empty()) throw CommandFailure(kCouldNot, outcome.trouble);
  if (outcome.summary.last.faults != kNoFault)
    throw CommandFailure(kNotSo, "the arm was stopped: " + faultList(outcome.summary.last.faults) + " at tick " +
                                     std::to_string(outcome.summary.last.tick) + " or before; " +
                                     whereToLook(outcome.summary));
  return kGood;
}

}  // namespace

void addRunCommand(const Command& program) {
  const auto options = std::make_shared<RunOptions>();
  const Command run = program.add("run", "Run a session without a window", [options] { return runSession(*options); });
  addRunOptions(run, *options);
}

}  // namespace haptiv
