#include "app/session/SessionSeat.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "app/version.h"
#include "device/kinematics/Vishard10.h"
#include "device/simulated/ScriptedHand.h"
#include "haptics/DeviceFrames.h"

namespace haptiv {
namespace {

constexpr double kHomeTolerance = 1e-6;  // [m]; the inverse function is exact but for rounding, or clamps by far more

}  // namespace

void expectUsable(const SessionSetup& setup) {
  if (!setup.scene) throw std::invalid_argument("a session needs a scene: load one without errors first");
  if (!std::isfinite(setup.rate) || setup.rate <= 0)
    throw std::runtime_error(
        "the rate of a session is a positive number of ticks per second: choose one, such as 1000");
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
  const Vishard10 arm(setup.description.links);
  const Vector3 home = placeInBase(setup.scene->device, setup.scene->tool.home);
  const JointVector start = arm.inverse(home, setup.description.homeAngles);
  const Vector3 reached = arm.forward(start).position;
  if (!((reached - home).norm() <= kHomeTolerance)) {
    std::ostringstream message;
    message << "the tool's home is at (" << home.transpose()
            << ") m from the device's base, out of the arm's reach; the "
            << "nearest place is (" << reached.transpose() << ") m. Move HapticTool's home, or HapticDevice";
    throw std::runtime_error(message.str());
  }
  return std::make_unique<SimulatedDevice>(setup.description, start, std::move(hand), setup.seed);
}

SessionHeader headerOf(const SessionSetup& setup) {
  SessionHeader header;
  header.sceneName = setup.sceneName;
  header.sceneText = setup.sceneText;
  header.deviceText = setup.description.text;
  header.softwareVersion = kVersion;
  header.gitHash = kGitHash;
  header.seed = setup.seed;
  header.rate = setup.rate;
  return header;
}

}  // namespace haptiv
