#pragma once

#include <array>
#include <cstdint>

#include "haptics/measuring/Measured.h"

namespace haptiv {

/// What is remembered of the handle's sensor.
struct SensorState {
  std::array<std::int16_t, 6> counts{};
  std::array<std::int32_t, 6> repeats{};  ///< ticks for which an axis has told the same count
};

/// Finds a force-torque sensor that does not tell what the hand does.
///
/// Saturated: a count at the end of the range. Implausible: a force that no hand has, `safety.handForceLimit`. Stuck:
/// one axis repeats its count for kStuckTime and kStuckTicks. That is watched where the description says that the noise
/// is half a count or more, so that a healthy axis flickers: a count repeats with a probability of 0.7 at the most, a
/// hundred times in a row once in the age of the world. An axis without noise may rest, and is not watched.
class SensorMonitor {
 public:
  static constexpr double kStuckTime = 0.1;  ///< [s]
  static constexpr double kStuckTicks = 100;

  SensorMonitor(const DeviceDescription& description, double period);

  /// Fault bits of this tick. Realtime-safe: yes.
  std::uint32_t operator()(const DeviceReading& reading, const Measured& measured, SensorState& state) const noexcept;

 private:
  bool stuck(const DeviceReading& reading, SensorState& state) const noexcept;

  std::array<std::int32_t, 6> saturation_{};  ///< counts at the end of the range
  std::array<bool, 6> flickers_{};
  std::int32_t mostRepeats_;
  double handForceLimit_;
};

}  // namespace haptiv
