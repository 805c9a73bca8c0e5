#include "app/commands/RunCommand.h"

#include <iostream>

#include "app/commands/ExitCode.h"
#include "app/commands/LiveRun.h"
#include "app/commands/LoadedScene.h"
#include "app/commands/Picture.h"
#include "app/commands/SessionReport.h"
#include "app/session/HandFile.h"
#include "app/session/Session.h"

namespace haptiv {
namespace {

constexpr double kSecondsAtRest = 5;    // of a session without a hand file
constexpr double kSecondsToSettle = 1;  // after the end of a hand file

// What the command line of a later version will offer is refused, never ignored.
void refuseWhatIsNotThere(const RunOptions& options) {
  if (options.device == "usb" || options.device.starts_with("usb:"))
    throw CommandFailure(
        kCouldNot, "--device " + options.device + ": this version drives the simulated arm only; use --device sim");
  if (options.device != "sim")
    throw CommandFailure(kWrongUsage, "--device " + options.device + ": there is no such device; use --device sim");
  if (options.strategy == "man" || options.strategy == "dir" || options.strategy == "cond")
    throw CommandFailure(kCouldNot, "--strategy " + options.strategy +
                                        ": this version resolves the redundancy without side criterion only; use "
                                        "--strategy nonopt");
  if (options.strategy != "nonopt")
    throw CommandFailure(kWrongUsage,
                         "--strategy " + options.strategy + ": there is no such strategy; use --strategy nonopt");
  if (options.solid)
    throw CommandFailure(kCouldNot, "--solid: this version knows the if-then walls only; leave --solid out");
}

SessionSetup setUp(const RunOptions& options, const LoadedScene& loaded) {
  SessionSetup setup;
  setup.scene = loaded.compiled.scene;
  setup.sceneName = loaded.file.path;
  setup.sceneText = loaded.file.text;
  setup.description = loaded.device;
  setup.rate = options.rate;
  if (options.hand != "rest") {
    requireReadable(options.hand);
    setup.hand = readHandFile(options.hand);
  }
  if (!options.log.empty()) setup.log = options.log;
  return setup;
}

double lengthOf(const RunOptions& options, const SessionSetup& setup) {
  if (options.seconds) {
    if (*options.seconds * options.rate < 1)
      throw CommandFailure(kWrongUsage, "--seconds: shorter than one tick; give more");
    return *options.seconds;
  }
  return setup.hand.empty() ? kSecondsAtRest : setup.hand.back().time + kSecondsToSettle;
}

// What came of a session that could be run, though not everything asked for beside it may have succeeded.
struct Outcome {
  SessionSummary summary;
  std::string scheduling;  // empty: --fast
  std::string trouble;     // with log or picture; empty: none
};

Outcome run(const RunOptions& options, const SessionSetup& setup) {
  const double seconds = lengthOf(options, setup);
  if (options.fast) return {runFast(setup, seconds), {}, {}};
  LiveRun live = runLive(setup, seconds);
  return {std::move(live.summary), std::move(live.scheduling), std::move(live.logTrouble)};
}

Report reportOf(const RunOptions& options, const Outcome& outcome) {
  Report report = reportOf(outcome.summary, options.rate);
  if (!outcome.scheduling.empty()) report.add("scheduling", outcome.scheduling);
  if (!options.log.empty()) report.add("log", options.log);
  if (!options.picture.empty()) report.add("picture", options.picture);
  return report;
}

}  // namespace

int runSession(const RunOptions& options) {
  refuseWhatIsNotThere(options);
  initSceneGraph();
  const LoadedScene loaded = loadScene(options.scene);
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
  reportOf(options, outcome).print(options.json);
  if (!outcome.trouble.empty()) throw CommandFailure(kCouldNot, outcome.trouble);
  if (outcome.summary.last.faults != kNoFault)
    throw CommandFailure(kNotSo, std::string("the arm was stopped: ") +
                                     faultName(static_cast<Fault>(outcome.summary.last.faults)) + " at tick " +
                                     std::to_string(outcome.summary.last.tick) + " or before; see the log");
  return kGood;
}

}  // namespace haptiv
