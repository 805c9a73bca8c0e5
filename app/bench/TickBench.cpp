#include <stdexcept>

#include "app/bench/Benches.h"
#include "app/bench/scenes/ArmOnFloor.h"
#include "device/replayed/ReplayedDevice.h"
#include "haptics/servo/FastLoop.h"
#include "haptics/servo/ServeTick.h"
#include "haptics/servo/ServoLoop.h"

namespace haptiv {
namespace {

constexpr int kTickPasses = 5;
constexpr std::size_t kTicks = 20000;

/// What the arm's encoders and sensor say while the hand wanders and presses; how often it is in contact.
std::vector<DeviceReading> readingsOf(const ArmOnFloor& arm, const HapticScene& scene, double& inContact) {
  std::vector<DeviceReading> readings;
  std::size_t touching = 0;
  runFast(*arm.device(), arm.description(), ArmOnFloor::kRate, scene, kTicks, [&](const TickRecord& record) {
    if (record.faults != kNoFault)
      throw std::runtime_error("the bench's arm has stopped: this is a fault of the program");
    readings.push_back(record.reading);
    if (record.contacts > 0) ++touching;
    return true;
  });
  inContact = static_cast<double>(touching) / kTicks;
  return readings;
}

/// As the servo's tick: read, tick, write, record for log and display.
void runPass(ReplayedDevice& device, const HapticTick& tick, const HapticScene& scene, ServoSeams& seams,
             CallTimes& times) {
  device.start(1 / ArmOnFloor::kRate);
  TickState state;
  const auto newestScene = [&]() noexcept -> const HapticScene& { return scene; };
  for (std::size_t i = 0; i < kTicks; ++i) {
    times.time([&] {
      const TickRecord record = serveTick(device, tick, newestScene, state);
      seams.log.push(record);
      seams.display.write(record);
      return record.faults;
    });
    if (i % 1024 == 0) seams.log.drain([](const TickRecord&) {});
  }
  seams.log.drain([](const TickRecord&) {});
  times.endPass();
}

}  // namespace

void benchTick(BenchRun& run) {
  run.tell("tick: " + std::to_string(ArmOnFloor::kWalls) + " walls");
  const ArmOnFloor arm;
  HapticScene scene = arm.scene();
  scene.resolution = ResolutionChoice{Strategy::dir, Solution::full};
  double inContact = 0;
  ReplayedDevice device(readingsOf(arm, scene, inContact));
  const HapticTick tick(arm.description(), 1 / ArmOnFloor::kRate);
  ServoSeams seams(ArmOnFloor::kRate);
  CallTimes times(kTicks);
  for (int pass = 0; pass < kTickPasses; ++pass) runPass(device, tick, scene, seams, times);
  BenchResult result = resultOf("tick/maze", ArmOnFloor::kWalls, times);
  result.notes = {{"in_contact", inContact}, {"processor_share_at_1_kHz", 1e-6 * result.medianNs}};
  run.add(result);
}

}  // namespace haptiv
