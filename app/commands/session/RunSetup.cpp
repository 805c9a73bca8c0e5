#include "app/commands/session/RunSetup.h"

#include <chrono>
#include <cmath>
#include <stdexcept>

#include "app/commands/ExitCode.h"
#include "app/commands/NamedFile.h"
#include "app/commands/session/RunPeople.h"
#include "app/session/Falcons.h"
#include "app/session/UsbBoards.h"
#include "app/session/choices/SceneControl.h"
#include "app/session/choices/SceneResolution.h"
#include "app/session/hands/HandFile.h"
#include "app/session/recording/FlightRecorder.h"
#include "device/control/ControlNames.h"
#include "device/control/ResolutionNames.h"
#include "scenegraph/writing/LastingText.h"

namespace haptiv {
namespace {

constexpr double kSecondsAtRest = 5;         // of a session without a hand file
constexpr double kSecondsToSettle = 1;       // after the end of a hand file
constexpr double kSecondsOfAPerson = 86400;  // of a session that somebody leads, and ends

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

/// As it was written, where it stands by itself.
std::string textForLog(const SceneFile& file) {
  if (file.fileOf.empty()) return file.text;
  try {
    return wholeText(file.root.get(), file.path);
  } catch (const std::runtime_error&) {
    return file.text;
  }
}

}  // namespace

SessionSetup setUp(const RunOptions& options, const LoadedScene& loaded) {
  SessionSetup setup;
  setup.scene = withResolution(loaded.compiled.scene, resolutionChoiceOf(options, loaded.device));
  setup.scene = withControl(setup.scene, controlChoiceOf(options, loaded.device));
  setup.sceneName = loaded.file.path;
  setup.sceneText = textForLog(loaded.file);
  setup.description = loaded.device;
  setup.rate = options.rate;
  setup.spin = std::chrono::nanoseconds(std::llround(1000 * options.spin));
  if (isBoard(options.device)) setup.device = boardOf(options.device, loaded.device);
  if (isFalcon(options.device)) setup.device = falconOf(options.device, options.firmware, loaded.device);
  setup.liveHand = isLedBySpaceMouse(options);
  if (options.hand != "rest" && !isLedBySpaceMouse(options)) {
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
  if (isOnDevice(options) || isLedBySpaceMouse(options)) return kSecondsOfAPerson;
  return setup.hand.empty() ? kSecondsAtRest : setup.hand.back().time + kSecondsToSettle;
}

}  // namespace haptiv
