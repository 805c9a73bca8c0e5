#pragma once

#include "device/described/DeviceDescription.h"

namespace haptiv {

/// Thresholds of the safety circuit, as the counters of the board hold them.
struct CircuitThresholds {
  std::int64_t watchdogTime = 10'000;                     ///< [us]
  std::int64_t velocityTimeUnit = 1'000;                  ///< [us]
  std::array<std::uint32_t, kJointCount> countThreshold;  ///< encoder impulses within the time unit

  bool operator==(const CircuitThresholds&) const = default;
};

/// What a board is built for.
struct BoardSettings {
  CircuitThresholds thresholds;
  JointVector rateLimit = JointVector::Zero();    ///< [rad/s]
  JointVector torqueLimit = JointVector::Zero();  ///< [N m]
};

/// The board of a described device. Times are rounded to microseconds, counts down; both are kept to what the counters
/// can hold: [1 us, 100 s], [1, 2^31).
BoardSettings boardSettings(const DeviceDescription& description);

/// Whether a host may set these: nowhere looser than what the board is built for, and no threshold zero.
bool noLooser(const CircuitThresholds& wanted, const CircuitThresholds& builtFor) noexcept;

}  // namespace haptiv
