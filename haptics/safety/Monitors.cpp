#include "haptics/safety/Monitors.h"

#include "haptics/safety/Faults.h"

namespace haptiv {

Monitors::Monitors(const DeviceDescription& description, double period)
    : sensor_(description, period),
      encoders_(description, period),
      missed_(description.safety.missedTime, period),
      oscillation_(description.safety, period),
      runaway_(description, period),
      toolSpeed_(description),
      trackingErrorLimit_(description.control.trackingErrorLimit) {}

std::uint32_t Monitors::operator()(const DeviceReading& reading, const Measured& measured, const Driven& driven,
                                   std::uint32_t missedTicks, MonitorState& state) const noexcept {
  std::uint32_t faults = faultsOfTrips(reading.trips);
  if (!reading.connected) faults |= kFaultDisconnected;
  if ((reading.inputs & kInputEmergencyStops) != 0) faults |= kFaultEmergencyStop;
  if (!measured.allFinite()) faults |= kFaultNotFinite;
  faults |= sensor_(reading, measured, state.sensor);
  faults |= encoders_(reading, driven.isLed ? &driven.desiredAngles : nullptr, state.encoders);
  faults |= missed_(missedTicks, state.missed);
  return faults | motion(measured, driven, state);
}

std::uint32_t Monitors::motion(const Measured& measured, const Driven& driven, MonitorState& state) const noexcept {
  if (!driven.running) {
    state.oscillation = {};
    state.runaway = 0;
    return kNoFault;
  }
  const double error = (driven.desiredAngles - measured.angles).cwiseAbs().maxCoeff();
  const std::uint32_t tracking = !driven.isLed || error <= trackingErrorLimit_ ? kNoFault : kFaultTracking;
  return tracking | toolSpeed_(measured) | oscillation_(driven.swinging, state.oscillation) |
         runaway_(driven.clamps, driven.swinging.velocity, measured.handForce, state.runaway);
}

}  // namespace haptiv
