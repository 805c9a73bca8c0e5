#include "app/commands/session/RunCommand.h"

#include <cmath>
#include <iostream>
#include <memory>
#include <optional>

#include "app/commands/DeviceName.h"
#include "app/commands/ExitCode.h"
#include "app/commands/Picture.h"
#include "app/commands/scene/LoadedScene.h"
#include "app/commands/session/LiveRun.h"
#include "app/commands/session/RunPeople.h"
#include "app/commands/session/SessionReport.h"
#include "app/session/Falcons.h"
#include "app/session/FlightRecorder.h"
#include "app/session/SceneControl.h"
#include "app/session/SceneResolution.h"
#include "app/session/Session.h"
#include "app/session/UsbBoards.h"
#include "app/session/hands/HandFile.h"
#include "app/session/hands/SpaceMouseChoice.h"
#include "device/control/ControlNames.h"
#include "device/redundancy/ResolutionNames.h"

namespace haptiv {
namespace {

constexpr Range kRates{kLowestServoRate, kHighestServoRate};
constexpr Range kSpins{0, 1000};             // [us]
constexpr Range kLengths{0, 86400, true};    // [s], up to a day
constexpr double kSecondsAtRest = 5;         // of a session without a hand file
constexpr double kSecondsToSettle = 1;       // after the end of a hand file
constexpr double kSecondsOfAPerson = 86400;  // of a session that somebody leads, and ends

/// Empty paths: not asked for.
struct RunOptions {
  std::string scene;
  std::string device = "sim";
  std::string firmware;  // of a Falcon; empty: where it is looked for
  std::string hand = "rest";
  std::optional<double> seconds;  // none: as long as the hand file, and a second more
  double rate = 1000;             // [Hz]
  double spin = 50;               // [us]
  std::string strategy;           // empty: as the device description says
  std::string solution;
  std::string control;
  std::string joints;
  std::string orientation;
  std::string passivity;
  std::string log;
  std::string picture;
  bool solid = false;
  bool fast = false;
  bool json = false;
};

bool isSpaceMouse(const RunOptions& options) {
  return spaceMouseNamed(options.hand).has_value();
}

void refuseWhatIsNotThere(const RunOptions& options) {
  if (options.device != "sim" && !isBoard(options.device) && !isFalcon(options.device))
    throw CommandFailure(kWrongUsage, "--device " + options.device +
                                          ": there is no such device; use sim, usb, usb:WHICH, falcon or falcon:WHICH, "
                                          "as haptiv device list names them");
  refuseWithoutName(options.device);
  if (isSpaceMouse(options)) refuseWithoutName(options.hand);
  if (!options.firmware.empty() && !isFalcon(options.device))
    throw CommandFailure(kWrongUsage, "--firmware: is a Falcon's; give --device falcon too, or leave it out");
}

// A person moves it, and time is that person's.
void refuseWhatNoPersonCanDo(const RunOptions& options) {
  const bool real = isFalcon(options.device) || isBoard(options.device);
  if (options.fast && (real || isSpaceMouse(options)))
    throw CommandFailure(kWrongUsage, "--fast: a person cannot keep up with it; leave --fast out");
  if (real && options.hand != "rest")
    throw CommandFailure(kWrongUsage, "--hand " + options.hand +
                                          ": is for the simulated arm, others are held by a real one; leave it out");
}

// What is asked for; where nothing is, what the device description says.
ResolutionChoice resolutionChoiceOf(const RunOptions& options, const DeviceDescription& device) {
  ResolutionChoice choice = device.redundancy.choice;
  choice.strategy = strategyNamed(options.strategy).value_or(choice.strategy);
  choice.solution = solutionNamed(options.solution).value_or(choice.solution);
  return choice;
}

ControlChoice controlChoiceOf(const RunOptions& options, const DeviceDescription& device) {
  ControlChoice choice = device.control.choice;
  choice.display = displayModeNamed(options.control).value_or(choice.display);
  choice.joints = jointControllerNamed(options.joints).value_or(choice.joints);
  choice.orientation = orientationModeNamed(options.orientation).value_or(choice.orientation);
  if (!options.passivity.empty()) choice.passivity = options.passivity == "on";
  return choice;
}

SessionSetup setUp(const RunOptions& options, const LoadedScene& loaded) {
  SessionSetup setup;
  setup.scene = withResolution(loaded.compiled.scene, resolutionChoiceOf(options, loaded.device));
  setup.scene = withControl(setup.scene, controlChoiceOf(options, loaded.device));
  setup.sceneName = loaded.file.path;
  setup.sceneText = loaded.file.text;
  setup.description = loaded.device;
  setup.rate = options.rate;
  setup.spin = std::chrono::nanoseconds(std::llround(1000 * options.spin));
  if (isBoard(options.device)) setup.device = boardOf(options.device, loaded.device);
  if (isFalcon(options.device)) setup.device = falconOf(options.device, options.firmware, loaded.device);
  setup.liveHand = isSpaceMouse(options);
  if (options.hand != "rest" && !isSpaceMouse(options)) {
    requireReadable(options.hand);
    setup.hand = readHandFile(options.hand);
  }
  if (!options.log.empty()) setup.log = options.log;
  if (options.log.empty()) setup.flights = flightFolder();
  return setup;
}

double lengthOf(const RunOptions& options, const SessionSetup& setup) {
  if (options.seconds) {
    if (*options.seconds * options.rate < 1)
      throw CommandFailure(kWrongUsage, "--seconds: shorter than one tick; give more");
    return *options.seconds;
  }
  if (isFalcon(options.device) || isBoard(options.device) || isSpaceMouse(options)) return kSecondsOfAPerson;
  return setup.hand.empty() ? kSecondsAtRest : setup.hand.back().time + kSecondsToSettle;
}

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
  refuseWhatIsNotThere(options);
  refuseWhatNoPersonCanDo(options);
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
  run.path("SCENE", options->scene, "Scene to be felt (.iv)").required();
  run.text(
         "--device", options->device,
         "The arm: sim; usb (usb:WHICH), an interface board; falcon (falcon:WHICH), a Novint Falcon; which there are, "
         "haptiv device list tells")
      .type("NAME")
      .showDefault();
  run.path("--firmware", options->firmware,
           "The Falcon's firmware, which its driver package holds; without this, ~/.local/share/haptiv/falcon.bin")
      .type("FILE");
  run.path(
         "--hand", options->hand,
         "Where the hand wants the ball, over time: a CSV file with the columns t,x,y,z in s and m; rest: nobody "
         "holds the ball; spacemouse or spacemouse:position: a SpaceMouse, whose cap says how fast or how far; :WHICH "
         "behind it where there are several")
      .type("FILE.csv")
      .showDefault();
  run.number("--seconds", options->seconds, kLengths,
             "How long; as long as the hand file and 1 s more, or 5 s; until Ctrl-C where a person leads")
      .type("S");
  run.number("--rate", options->rate, kRates, "Ticks per second, 500 to 8000").type("HZ").showDefault();
  run.number(
         "--spin", options->spin, kSpins,
         "How long before each tick the servo waits awake, up to a quarter of the period: wakes in time, for a part "
         "of a processor")
      .type("US")
      .showDefault();
  run.choice("--strategy", options->strategy, {"nonopt", "man", "dir", "cond"},
             "What the arm's redundancy serves; without this, as the device description says")
      .type("nonopt|man|dir|cond");
  run.choice("--solution", options->solution, {"full", "partitioned"},
             "All joints at once, or position and orientation apart; without this, as the device description says")
      .type("full|partitioned");
  run.choice("--control", options->control, {"admittance", "position-impedance", "impedance"},
             "What the device shows of the scene: a motion, or a force; without this, as the device description says")
      .type("admittance|position-impedance|impedance");
  run.choice("--joints", options->joints, {"pd", "computed-torque"},
             "How the joints follow the desired motion; without this, as the device description says")
      .type("pd|computed-torque");
  run.choice("--orientation", options->orientation, {"held", "free"},
             "Whether the hand can turn the handle; without this, as the device description says")
      .type("held|free");
  run.choice("--passivity", options->passivity, {"on", "off"},
             "Passivity control at the tool; without this, as the device description says")
      .type("on|off");
  run.path("--log", options->log, "Log every tick to this HDF5 file").type("FILE.h5");
  run.path("--picture", options->picture, "Draw the end of the session, 1280 x 720; needs no display").type("FILE.png");
  run.flag("--fast", options->fast, "As fast as the machine allows, and repeatable bit for bit");
  run.flag("--solid", options->solid,
           "Make a scene that is only seen felt: adds a ball and a surface of its size; the file stays as it is");
  run.json(options->json);
}

}  // namespace haptiv
