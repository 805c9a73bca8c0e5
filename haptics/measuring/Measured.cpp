#include "haptics/measuring/Measured.h"

#include <cmath>

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

Measured Measuring::operator()(const DevicePlacement& device, const DeviceReading& reading,
                               MeasuringState& state) const noexcept {
  Measured measured;
  measured.angles = description_.jointAngles(reading);
  if (state.started) {
    state.rates += share_ * ((measured.angles - state.angles) / period_ - state.rates);
  }
  state.started = true;
  state.angles = measured.angles;
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
