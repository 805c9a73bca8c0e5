#include "app/session/SessionSeat.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "app/session/choices/SceneControl.h"
#include "app/session/choices/SceneResolution.h"
#include "app/session/version.h"
#include "device/simulated/ScriptedHand.h"
#include "haptics/scene/DeviceFrames.h"
#include "haptics/scene/SceneNumbers.h"
#include "haptics/servo/SessionStart.h"

namespace haptiv {
void expectFeelable(const HapticScene& scene) {
  if (const std::string wrong = wrongNumberIn(scene); !wrong.empty())
    throw std::runtime_error("a scene in which " + wrong + " cannot be felt, nor read back from a log: mend it");
}

void expectUsable(const SessionSetup& setup) {
  if (!setup.scene) throw std::invalid_argument("a session needs a scene: load one without errors first");
  if (!(setup.rate > 0 && setup.rate <= kHighestServoRate))
    throw std::runtime_error("the rate of a session is above 0, up to 8000 ticks per second: choose one, such as 1000");
  expectFeelable(*setup.scene);
  expectResolvable(resolutionOf(*setup.scene, setup.description), setup.description);
  expectControllable(controlOf(*setup.scene, setup.description), setup.description);
  if (!setup.log) return;
  const std::filesystem::path folder = setup.log->has_parent_path() ? setup.log->parent_path() : ".";
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error))
    throw std::runtime_error(setup.log->string() + ": cannot write a log there: the folder does not exist. Create " +
                             folder.string() + " first");
  if (setup.description.text.empty())
    throw std::runtime_error(setup.log->string() + ": a log needs the text of the device description: load it from a " +
                             "file with loadDeviceDescription");
}

std::unique_ptr<HandSource> scriptedHand(const SessionSetup& setup) {
  std::vector<HandWaypoint> waypoints = setup.hand;
  for (HandWaypoint& waypoint : waypoints) waypoint.position = placeInBase(setup.scene->device, waypoint.position);
  return std::make_unique<ScriptedHand>(std::move(waypoints));
}

std::unique_ptr<SimulatedDevice> simulatedDevice(const SessionSetup& setup, std::unique_ptr<HandSource> hand) {
  const SessionStart start = sessionStart(*setup.scene, setup.description);
  if (!start.inReach()) {
    std::ostringstream message;
    message << "the tool's home is at (" << start.wanted.transpose()
            << ") m from the device's base, out of the arm's reach; the "
            << "nearest place is (" << start.reached.transpose() << ") m. Move HapticTool's home, or HapticDevice";
    throw std::runtime_error(message.str());
  }
  return std::make_unique<SimulatedDevice>(setup.description, start.angles, std::move(hand), setup.seed);
}

std::unique_ptr<FlightRecorder> flightRecorder(const SessionSetup& setup, const SessionHeader& header) {
  if (!setup.log && !setup.flights) return nullptr;
  const std::filesystem::path folder = setup.flights ? *setup.flights : setup.log->parent_path();
  const std::string stem = setup.log ? setup.log->stem().string() : "haptiv";
  auto recorder = std::make_unique<FlightRecorder>(header, folder.empty() ? "." : folder, stem);
  recorder->addScene(setup.scene, setup.sceneText);
  return recorder;
}

SessionHeader headerOf(const SessionSetup& setup) {
  SessionHeader header;
  header.sceneName = setup.sceneName;
  header.sceneText = setup.sceneText.get();
  header.deviceText = setup.description.text;
  header.softwareVersion = kVersion;
  header.gitHash = kGitHash;
  header.seed = setup.seed;
  header.rate = setup.rate;
  return header;
}

}  // namespace haptiv
