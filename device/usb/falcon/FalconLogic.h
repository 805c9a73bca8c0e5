#pragma once

#include "device/described/DeviceDescription.h"
#include "device/usb/falcon/FalconPackets.h"

namespace haptiv::falcon {

/// How far the encoders' zeros are known.
enum class Homing : std::uint8_t {
  searching,  ///< the operator has to pull the grip out and push it in: what is counted means nothing yet
  homed,      ///< counts are angles
  lost,       ///< they were, and a leg has lost its zero: only a new start helps, for the grip would seem to jump
};

Homing next(Homing homing, std::uint8_t homedLegs) noexcept;

/// Between what the servo means and what a Falcon says: counts and buttons to a reading, a command to motor values.
/// Realtime-safe: yes.
class Logic {
 public:
  explicit Logic(const DeviceDescription& description) noexcept;

  /// The counter of a leg is zero at homedAngle; a reading's count is zero where the joint is. The grip's round button
  /// is the dead-man, the one before it the reset; neither counts, and nothing is connected, but where all is homed.
  DeviceReading reading(const State& state, Homing homing) const noexcept;

  /// Torques at the legs as motor values, within the description's limits. Zero wherever anything forbids them: not
  /// homed, not enabled, not asked for as torques, the dead-man released, no numbers.
  Order order(const DeviceCommand& command, const State& state, Homing homing) const noexcept;

  static constexpr std::uint8_t kDeadManButton = 1u << 2, kResetButton = 1u << 1;

 private:
  std::int32_t zeroCounts_[3];
  double torqueLimit_[3];
  double torqueCounts_;
  double mostCounts_;
};

}  // namespace haptiv::falcon
