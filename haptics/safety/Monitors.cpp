#include "haptics/safety/Monitors.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace haptiv {
namespace {

/// The sensor's count at the end of its range; the count itself ends at 16 bits.
std::int32_t lastCount(double range, double resolution) {
  constexpr double kLargest = std::numeric_limits<std::int16_t>::max();
  return static_cast<std::int32_t>(std::min(std::floor(range / resolution), kLargest));
}

}  // namespace

Monitors::Monitors(const DeviceDescription& description) : trackingErrorLimit_(description.control.trackingErrorLimit) {
  const HandleSensor& sensor = description.sensor;
  const std::int32_t force = lastCount(sensor.forceRange, sensor.forceResolution);
  const std::int32_t torque = lastCount(sensor.torqueRange, sensor.torqueResolution);
  saturation_ = {force, force, force, torque, torque, torque};
}

std::uint32_t Monitors::operator()(const DeviceReading& reading, const Measured& measured,
                                   const JointVector* desired) const noexcept {
  std::uint32_t faults = kNoFault;
  if (!reading.connected) faults |= kFaultDisconnected;
  for (std::size_t i = 0; i < saturation_.size(); ++i) {
    if (std::abs(std::int32_t{reading.sensorCounts[i]}) >= saturation_[i]) faults |= kFaultSensorSaturated;
  }
  if (!measured.allFinite()) faults |= kFaultNotFinite;
  if (desired != nullptr && !((*desired - measured.angles).cwiseAbs().maxCoeff() <= trackingErrorLimit_))
    faults |= kFaultTracking;
  return faults;
}

}  // namespace haptiv
