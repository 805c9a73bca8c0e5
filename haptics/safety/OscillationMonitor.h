#pragma once

#include <array>
#include <cstdint>

#include "device/types.h"

namespace haptiv {

/// What is remembered of one direction's swinging.
struct SwingState {
  double mean = 0;              ///< of the velocity, behind the low-pass [m/s]
  double peak = 0;              ///< of the half swing that runs [m/s]
  double lastPeak = 0;          ///< of the one before [m/s]
  double time = 0;              ///< for which the half swing has run [s]
  bool up = false;              ///< its sign
  std::int32_t halfSwings = 0;  ///< in a row that were fast, wide and not dying down
};

struct OscillationState {
  std::array<SwingState, 3> axis;
};

/// Finds a contact, or a grip, that is not stable: the virtual mass swings at 20 Hz or more, which no hand does by
/// itself, by `safety.oscillationSpeed` or more to either side, and the swings do not die down: kHalfSwings in a row,
/// each at least 0.9 times the one before. A mass that rings after an impact loses more than that with each half swing
/// (damping ratio 0.03 and more), and is not told.
///
/// Looked at is what is left of the velocity behind a high-pass of 5 Hz, for each axis of W.
class OscillationMonitor {
 public:
  static constexpr std::int32_t kHalfSwings = 8;

  OscillationMonitor(double oscillationSpeed, double period) : least_(oscillationSpeed), period_(period) {}

  /// @param velocity  of the virtual mass, at the device [m/s]
  /// @return          kFaultOscillation, or none
  /// Realtime-safe: yes.
  std::uint32_t operator()(const Vector3& velocity, OscillationState& state) const noexcept;

 private:
  bool swings(double velocity, SwingState& state) const noexcept;

  double least_, period_;
};

}  // namespace haptiv
