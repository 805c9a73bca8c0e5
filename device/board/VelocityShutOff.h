#pragma once

#include "device/board/BoardSettings.h"

namespace haptiv {

/// The shut-off by joint velocity: for each joint two counters, running in parallel      [paper, section III.D]
///
/// The reference counter reaches countThreshold within velocityTimeUnit, whatever the joint does; the second one counts
/// the encoder's impulses of the same time, of either direction. The joint is too fast when the impulses exceed what
/// the reference counter reads at the end of the unit; both then begin anew.
///
/// A joint that turns faster than countThreshold a unit is seen within two units at the latest, one that counts twice
/// as fast within one. When the board looks less often than once a unit, the reference counter has gone on meanwhile.
/// All of it in integers. Realtime-safe: yes.
class VelocityShutOff {
 public:
  /// @param now  [us]; the counters begin here
  void begin(const CircuitThresholds& thresholds, std::int64_t now,
             const std::array<std::int32_t, kJointCount>& counts) noexcept;

  /// Bit i: joint i + 1 is too fast. Time that runs backwards counts as none.
  std::uint16_t count(std::int64_t now, const std::array<std::int32_t, kJointCount>& counts) noexcept;

  /// Bit i: the encoder of joint i + 1 jumped in the last count, by eight times what is too fast already.
  std::uint16_t jumps() const noexcept { return jumps_; }

 private:
  CircuitThresholds thresholds_{};
  std::int64_t unitBegan_ = 0;
  std::array<std::int32_t, kJointCount> last_{};
  std::array<std::int64_t, kJointCount> impulses_{};
  std::uint16_t jumps_ = 0;
};

}  // namespace haptiv
