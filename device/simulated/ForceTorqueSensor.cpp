#include "device/simulated/ForceTorqueSensor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace haptiv {

namespace {

std::int16_t counts(double value, double range, double resolution) noexcept {
  const double most = std::min<double>(std::floor(range / resolution), std::numeric_limits<std::int16_t>::max());
  return static_cast<std::int16_t>(std::clamp(std::round(value / resolution), -most, most));
}

}  // namespace

void ForceTorqueSensor::follow(const Wrench& wrench, double dt) noexcept {
  const double part = -std::expm1(-sensor_.bandwidth * dt);
  filtered_.force += part * (wrench.force - filtered_.force);
  filtered_.torque += part * (wrench.torque - filtered_.torque);
}

std::array<std::int16_t, 6> ForceTorqueSensor::measure() noexcept {
  std::array<std::int16_t, 6> measured{};
  Vector6 wrench;
  wrench << filtered_.force, filtered_.torque;
  const Vector6 said = crosstalk_ * wrench + sensor_.bias;
  for (int i = 0; i < 3; ++i) {
    const double force = said[i] + sensor_.forceNoise * noise_.next();
    measured[i] = counts(force, sensor_.forceRange, sensor_.forceResolution);
  }
  for (int i = 0; i < 3; ++i) {
    const double torque = said[3 + i] + sensor_.torqueNoise * noise_.next();
    measured[3 + i] = counts(torque, sensor_.torqueRange, sensor_.torqueResolution);
  }
  return measured;
}

}  // namespace haptiv
