#pragma once

#include <array>
#include <cstdint>

#include "device/DeviceDescription.h"
#include "device/simulated/Noise.h"
#include "device/types.h"

namespace haptiv {

/// The six-axis sensor at the handle: a low-pass of first order, noise, saturation at its range, 16-bit counts.
class ForceTorqueSensor {
 public:
  ForceTorqueSensor(const HandleSensor& sensor, std::uint64_t seed) : sensor_(sensor), noise_(seed) {}

  /// The wrench in T, which acts for dt [s]. Realtime-safe: yes.
  void follow(const Wrench& wrench, double dt) noexcept;
  /// A sample as counts: force x y z, torque x y z. Realtime-safe: yes.
  std::array<std::int16_t, 6> measure() noexcept;

 private:
  HandleSensor sensor_;
  Noise noise_;
  Wrench filtered_;
};

}  // namespace haptiv
