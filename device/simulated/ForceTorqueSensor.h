#pragma once

#include <Eigen/LU>
#include <array>
#include <cstdint>

#include "device/described/DeviceDescription.h"
#include "device/simulated/Noise.h"
#include "device/types.h"

namespace haptiv {

/// The six-axis sensor at the handle: a low-pass of first order, crosstalk and bias as the description's matrix and
/// bias take them out again, noise, saturation at its range, 16-bit counts.
class ForceTorqueSensor {
 public:
  ForceTorqueSensor(const HandleSensor& sensor, std::uint64_t seed)
      : sensor_(sensor), crosstalk_(sensor.matrix.inverse()), noise_(seed) {}

  /// The wrench in T, which acts for dt [s]. Realtime-safe: yes.
  void follow(const Wrench& wrench, double dt) noexcept;
  /// A sample as counts: force x y z, torque x y z. Realtime-safe: yes.
  std::array<std::int16_t, 6> measure() noexcept;

 private:
  HandleSensor sensor_;
  Matrix6 crosstalk_;  // from the wrench to what the sensor says, without bias
  Noise noise_;
  Wrench filtered_;
};

}  // namespace haptiv
