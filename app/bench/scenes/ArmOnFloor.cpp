#include "app/bench/scenes/ArmOnFloor.h"

#include <cmath>

#include "device/kinematics/ArmKinematics.h"
#include "device/simulated/ScriptedHand.h"
#include "haptics/scene/DeviceFrames.h"
#include "haptics/servo/SessionStart.h"

namespace haptiv {

ArmOnFloor::ArmOnFloor(std::uint32_t walls)
    : description_(loadDeviceDescription("vishard10")), scene_(WallFloor(walls, 0.1).scene()) {
  const double width = std::sqrt(walls) * 3 * scene_.tool.radius;
  scene_.tool.home = {width / 2, width / 2, 10 * scene_.tool.radius};
  scene_.tool.mass = 2;
  const Vector3 p_BT = ArmKinematics(description_).forward(description_.homeAngles).position;
  scene_.device.position = scene_.tool.home - p_BT;
}

std::vector<HandWaypoint> ArmOnFloor::hand() const {
  std::vector<HandWaypoint> way;
  const double reach = scene_.tool.home.x() * 2 / 3;  // [m] about the middle
  for (int i = 0; i <= 60; ++i) {
    const double high = i % 10 == 0 ? 0.02 : -0.01;  // [m] above home: it lifts now and then
    const Vector3 aside(reach * std::sin(1.3 * i), reach * std::cos(0.7 * i), high);
    way.push_back({0.4 * i, scene_.tool.home + (i == 0 ? Vector3(0, 0, 0) : aside)});
  }
  return way;
}

std::unique_ptr<SimulatedDevice> ArmOnFloor::device() const {
  std::vector<HandWaypoint> way = hand();
  for (HandWaypoint& waypoint : way) waypoint.position = placeInBase(scene_.device, waypoint.position);
  const SessionStart start = sessionStart(scene_, description_);
  return std::make_unique<SimulatedDevice>(description_, start.angles, std::make_unique<ScriptedHand>(way), 1);
}

}  // namespace haptiv
