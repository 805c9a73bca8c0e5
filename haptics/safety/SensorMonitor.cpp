#include "haptics/safety/SensorMonitor.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "haptics/safety/Faults.h"

namespace haptiv {
namespace {

constexpr double kFlickers = 0.5;  // [counts] of noise that an axis needs in order to be watched

}  // namespace

SensorMonitor::SensorMonitor(const DeviceDescription& description, double period)
    : mostRepeats_(static_cast<std::int32_t>(std::max(std::ceil(kStuckTime / period), kStuckTicks))),
      handForceLimit_(description.safety.handForceLimit) {
  const HandleSensor& sensor = description.sensor;
  const auto last = sensor.lastCounts();
  for (std::size_t i = 0; i < 6; ++i) {
    const bool force = i < 3;
    const double resolution = force ? sensor.forceResolution : sensor.torqueResolution;
    saturation_[i] = last[i];
    flickers_[i] = (force ? sensor.forceNoise : sensor.torqueNoise) >= kFlickers * resolution;
  }
}

std::uint32_t SensorMonitor::operator()(const DeviceReading& reading, const Measured& measured,
                                        SensorState& state) const noexcept {
  std::uint32_t faults = kNoFault;
  for (std::size_t i = 0; i < saturation_.size(); ++i) {
    if (std::abs(std::int32_t{reading.sensorCounts[i]}) >= saturation_[i]) faults |= kFaultSensorSaturated;
  }
  if (measured.handForce.norm() > handForceLimit_) faults |= kFaultHandForce;
  if (stuck(reading, state)) faults |= kFaultSensorStuck;
  return faults;
}

bool SensorMonitor::stuck(const DeviceReading& reading, SensorState& state) const noexcept {
  bool found = false;
  for (std::size_t i = 0; i < 6; ++i) {
    const bool repeated = reading.connected && reading.sensorCounts[i] == state.counts[i];
    state.repeats[i] = repeated ? std::min(state.repeats[i] + 1, mostRepeats_) : 0;
    found = found || (flickers_[i] && state.repeats[i] >= mostRepeats_);
  }
  state.counts = reading.sensorCounts;
  return found;
}

}  // namespace haptiv
