#pragma once

#include "device/board/BoardSettings.h"
#include "device/board/BoardSignals.h"
#include "device/board/TripLatch.h"
#include "device/board/VelocityShutOff.h"

namespace haptiv {

/// The interface board between host and arm: its firmware's logic, without wires. docs/board.md tells it in words.
///
/// It is the safety circuit of the paper's section III.D, and independent of the host: a watchdog that only a valid
/// command with a changed heartbeat feeds, the shut-off by joint velocity, emergency stops and the dead-man. What stops
/// the drives is latched until the operator resets. The same board stands inside the simulated device and behind the
/// virtual USB bus.
///
///     board.advance(now, inputs);   // often: at least every half watchdog time
///     board.accept(command);        // when a frame has come in
///     drives.follow(board.demand());
///
/// Its clock is the caller's, in microseconds. Realtime-safe: yes, all of it: no allocation, deterministic.
class Board {
 public:
  explicit Board(const BoardSettings& settings) noexcept;

  /// Looks at the wires and at the clock. Time that runs backwards counts as none.
  void advance(std::int64_t now, const BoardInputs& inputs) noexcept;

  /// A command whose frame was whole. A refused one changes no set-point and does not feed the watchdog.
  /// Finite set-points beyond the drives' limits are cut to them.
  Acceptance accept(const BoardCommand& command) noexcept;

  /// Counts a frame that was not whole; it has no other effect.
  void countDamaged() noexcept { ++counters_.damaged; }

  /// What the drives shall do now: never anything but finite set-points within their limits, or the brake.
  DriveDemand demand() const noexcept;

  BoardReport report() const noexcept;

  /// Sets the thresholds of the safety circuit. False: the drives are on, or one is looser than the board is built for;
  /// nothing has changed then.
  bool configure(const CircuitThresholds& thresholds) noexcept;
  const CircuitThresholds& thresholds() const noexcept { return thresholds_; }
  const BoardSettings& settings() const noexcept { return settings_; }

  /// Makes the encoders report these counts at the arm's present pose. False: the drives are on; nothing has changed.
  bool home(const std::array<std::int32_t, kJointCount>& counts) noexcept;
  /// Whether the encoders have been given a zero since the board was switched on.
  bool homed() const noexcept { return homed_; }

 private:
  bool fed() const noexcept { return everFed_ && now_ - fedAt_ <= thresholds_.watchdogTime; }
  bool driving() const noexcept { return latch_.armed() && command_.drive.enabled && fed(); }
  std::uint32_t causes(const BoardInputs& inputs, bool wasDriving) noexcept;
  /// The dead-man was released while the drives were on: they brake at once, and that is no fault; but a host that
  /// enables them for longer than the watchdog's time after it does not see the operator.
  bool isDeadManIgnored(const BoardInputs& inputs, bool wasDriving) noexcept;

  BoardSettings settings_;
  CircuitThresholds thresholds_;
  VelocityShutOff shutOff_;
  TripLatch latch_;
  BoardInputs inputs_;
  std::array<std::int32_t, kJointCount> countOffsets_{};
  BoardCommand command_;  // the newest accepted one, its set-points within the limits
  BoardCounters counters_;
  std::int64_t now_ = 0;
  std::int64_t fedAt_ = 0;
  std::int64_t releasedAt_ = 0;  // the dead-man, while the drives were on
  bool awaitsHost_ = false;      // to take its command back since then
  bool everFed_ = false;
  bool started_ = false;
  bool homed_ = false;
};

}  // namespace haptiv
