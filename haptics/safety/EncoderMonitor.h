#pragma once

#include <array>
#include <cstdint>

#include "haptics/measuring/Measured.h"

namespace haptiv {

/// What is remembered of the encoders.
struct EncoderState {
  bool started = false;
  std::array<std::int32_t, kJointCount> counts{};
  std::array<std::int64_t, kJointCount> impulses{};  ///< of each joint within the time unit that runs
  std::int32_t ticksOfUnit = 0;                      ///< that have passed of it
  bool sent = false;
  JointVector sentAt = JointVector::Zero();       ///< where each joint was sent when its encoder last moved [rad]
  std::array<std::int32_t, kJointCount> still{};  ///< ticks since then
};

/// Finds encoders that do not tell where the joints are, and joints that are too fast.
///
/// Too fast: more than `countThreshold` impulses within `velocityTimeUnit`, as the device's own circuit counts them
/// [paper, section III.D]. Jump: more than three times as many within a tick, which no joint can. Stuck: the count has
/// stood still for longer than kStuckTime and kStuckTicks while the joint was sent on by kStuck: soon, for the
/// controller pushes a joint that seems to stand. An encoder that jumps is not told to be too fast too.
class EncoderMonitor {
 public:
  static constexpr double kStuck = 0.002;      ///< [rad]: 130 counts
  static constexpr double kStuckTime = 0.003;  ///< [s]
  static constexpr std::int32_t kStuckTicks = 2;

  EncoderMonitor(const DeviceDescription& description, double period);

  /// @param desired  joint angles that the joint controller was given; null where the arm follows none
  /// @return         Fault bits of this tick
  /// Realtime-safe: yes.
  std::uint32_t operator()(const DeviceReading& reading, const JointVector* desired,
                           EncoderState& state) const noexcept;

 private:
  std::uint32_t moved(const DeviceReading& reading, EncoderState& state) const noexcept;
  bool stuck(const DeviceReading& reading, const JointVector* desired, EncoderState& state) const noexcept;

  std::int32_t ticksPerUnit_;
  std::int32_t mostStill_;                             ///< ticks
  std::array<std::int64_t, kJointCount> threshold_{};  ///< impulses within ticksPerUnit_
  std::array<std::int64_t, kJointCount> jump_{};       ///< impulses within a tick
};

}  // namespace haptiv
