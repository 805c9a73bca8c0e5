#include "device/simulated/FaultySensors.h"

#include "device/board/WrappingSum.h"

namespace haptiv {

FaultySensors::FaultySensors(const HandleSensor& sensor) : saturated_(sensor.lastCounts()) {}

BoardInputs FaultySensors::falsify(const BoardInputs& whole, const InjectedFaults& faults) noexcept {
  BoardInputs said = whole;
  for (std::size_t axis = 0; axis < said.sensorCounts.size(); ++axis) {
    const auto has = [axis](unsigned mask) { return (mask >> axis & 1u) != 0; };
    std::int16_t& count = said.sensorCounts[axis];
    if (has(faults.sensorStuck)) count = last_.sensorCounts[axis];
    if (has(faults.sensorSaturated)) count = saturated_[axis];
    if (has(faults.sensorDead)) count = 0;
  }
  for (std::size_t joint = 0; joint < said.encoderCounts.size(); ++joint) {
    std::int32_t& count = said.encoderCounts[joint];
    count = sumWrapping(count, faults.encoderJump[joint]);
    if ((faults.encoderStuck >> joint & 1u) != 0) count = last_.encoderCounts[joint];
  }
  said.encoderFaults |= faults.encoderBroken;
  said.powerGood = said.powerGood && !faults.powerLost;
  last_ = said;
  return said;
}

}  // namespace haptiv
