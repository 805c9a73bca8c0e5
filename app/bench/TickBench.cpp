#include <stdexcept>

#include "app/bench/ArmOnFloor.h"
#include "app/bench/Benches.h"
#include "haptics/HapticTick.h"

namespace haptiv {
namespace {

constexpr int kPasses = 5;
constexpr std::size_t kTicks = 20000;

}  // namespace

void benchTick(BenchRun& run) {
  run.tell("tick: " + std::to_string(ArmOnFloor::kWalls) + " walls");
  const ArmOnFloor arm;
  const HapticTick tick(arm.description(), 1 / ArmOnFloor::kRate);
  CallTimes times(kTicks);
  std::size_t inContact = 0;
  for (int pass = 0; pass < kPasses; ++pass) {
    const auto device = arm.device();
    device->start(1 / ArmOnFloor::kRate);
    TickState state;
    for (std::size_t i = 0; i < kTicks; ++i) {
      const DeviceReading reading = device->read();
      const TickRecord record = times.time([&] { return tick(arm.scene(), reading, state); });
      device->write(record.command);
      if (record.contacts > 0) ++inContact;
      if (record.faults != kNoFault)
        throw std::runtime_error("the bench's arm has stopped: this is a fault of the program");
    }
    device->stop();
    times.endPass();
  }
  BenchResult result = resultOf("tick/maze", ArmOnFloor::kWalls, times);
  result.notes = {{"in_contact", static_cast<double>(inContact) / (kPasses * kTicks)}};
  run.add(result);
}

}  // namespace haptiv
