#include "haptics/measuring/Measured.h"

#include <cmath>

#include "device/DeviceTime.h"
#include "haptics/scene/DeviceFrames.h"

namespace haptiv {
Measuring::Measuring(const DeviceDescription& description, double period)
    : description_(description),
      arm_(description),
      period_(period),
      share_(-std::expm1(-period * description.control.velocityBandwidth)) {}

bool Measured::allFinite() const noexcept {
  return p_WT.allFinite() && v_WT.allFinite() && handForce.allFinite() && handTorque.allFinite();
}

/// Angles and rates.
void Measuring::follow(const JointVector& angles, const DeviceReading& reading, MeasuringState& state) const noexcept {
  if (!state.started || !reading.connected) {
    state = {reading.connected, reading.deviceTime, angles, JointVector::Zero()};
    return;
  }
  const double passed = timeBetween(state.deviceTime, reading.deviceTime, period_);
  if (passed == 0) return;
  const double share = passed == period_ ? share_ : -std::expm1(-passed * description_.control.velocityBandwidth);
  state.rates += share * ((angles - state.angles) / passed - state.rates);
  state.angles = angles;
  state.deviceTime = reading.deviceTime;
}

Measured Measuring::operator()(const DevicePlacement& device, const DeviceReading& reading,
                               MeasuringState& state) const noexcept {
  Measured measured;
  measured.angles = description_.jointAngles(reading);
  follow(measured.angles, reading, state);
  measured.rates = state.rates;

  measured.arm = arm_.evaluate(measured.angles);
  const Vector3 v_BT = measured.arm.J_BT.topRows<3>() * measured.rates;
  measured.p_WT = placeInScene(device, measured.arm.X_BT.position);
  measured.v_WT = device.scale * (device.rotation * v_BT);
  const Wrench wrench_T = description_.handleWrench(reading);
  const Vector3 force_B = measured.arm.X_BT.rotation * wrench_T.force;
  const Vector3 torque_B = measured.arm.X_BT.rotation * wrench_T.torque;
  measured.handForce = device.rotation * force_B;
  measured.handTorque = device.rotation * torque_B;
  return measured;
}

}  // namespace haptiv
