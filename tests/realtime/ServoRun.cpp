#include "tests/realtime/ServoRun.h"

#include <chrono>
#include <cmath>
#include <memory>
#include <thread>

#include "device/kinematics/ArmKinematics.h"
#include "tests/realtime/CrowdedScene.h"

namespace haptiv::testing {

HandTarget PullingHand::at(double time) noexcept {
  HandTarget target;
  target.holding = time > 0.02;
  target.inputs = target.holding ? std::uint16_t{kInputDeadMan} : std::uint16_t{0};
  target.position = home_ + 0.05 * Vector3(std::sin(10 * time), std::sin(7 * time), std::sin(13 * time));
  return target;
}

Vector3 homeOf(const DeviceDescription& description) {
  return ArmKinematics(description).forward(description.homeAngles).position;
}

SimulatedDevice pulledArm(const DeviceDescription& description) {
  return {description, description.homeAngles, std::make_unique<PullingHand>(homeOf(description)), 1};
}

std::vector<TickRecord> runServo(HapticDevice& device, const DeviceDescription& description, std::uint64_t ticks) {
  const Vector3 home = homeOf(description);
  ServoSeams seams(1000);
  const auto publish = [&](std::uint32_t version) {
    auto scene = std::make_shared<HapticScene>(crowdedScene(home, version));
    scene->resolution = ResolutionChoice{static_cast<Strategy>(version % 4), static_cast<Solution>(version / 4 % 2)};
    scene->control = ControlChoice{static_cast<DisplayMode>(version % 3), static_cast<JointController>(version / 3 % 2),
                                   static_cast<OrientationMode>(version / 6 % 2), version % 2 == 0};
    computeBounds(*scene);
    seams.scene.write(std::move(scene));
  };
  std::vector<TickRecord> records;
  publish(1);
  ServoLoop loop(device, description, {1000}, seams);
  loop.start();
  for (std::uint32_t version = 1; seams.display.read().tick < ticks; seams.display.update()) {
    if (seams.display.read().tick > 50 * version) publish(++version);
    seams.log.drain([&](const TickRecord& record) { records.push_back(record); });
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  loop.stop();
  seams.log.drain([&](const TickRecord& record) { records.push_back(record); });
  return records;
}

}  // namespace haptiv::testing
