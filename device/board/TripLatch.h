#pragma once

#include <cstdint>

#include "device/safety/SafetySignals.h"

namespace haptiv {

/// Holds why the drives are stopped until the operator has seen to it.
///
/// A trip stays, its cause gone or not. It is cleared when reset is asked for (an edge, at the board or at the host)
/// while the dead-man is released and no cause stands. The drives are free again once the dead-man is pressed after
/// that: it has to be seen released first, so one that is jammed or tied down never starts the arm.
class TripLatch {
 public:
  /// @param causes   Trip bits that stand now
  /// @param buttons  OperatorInput bits
  /// @param reset    the host's wish, as a level
  void update(std::uint32_t causes, std::uint16_t buttons, bool reset) noexcept {
    const bool deadMan = (buttons & kInputDeadMan) != 0;
    const bool asked = reset || (buttons & kInputReset) != 0;
    const bool resetEdge = asked && !asked_;
    asked_ = asked;
    if (resetEdge && !deadMan) trips_ = kNoTrip;
    trips_ |= causes;
    if (trips_ != kNoTrip || !deadMan)
      armed_ = false;
    else if (!deadMan_)
      armed_ = true;
    deadMan_ = deadMan;
  }
  /// A cause that does not wait for the next update.
  void trip(std::uint32_t causes) noexcept {
    trips_ |= causes;
    if (trips_ != kNoTrip) armed_ = false;
  }

  std::uint32_t trips() const noexcept { return trips_; }
  bool armed() const noexcept { return armed_; }  ///< the operator lets the arm move

 private:
  std::uint32_t trips_ = kNoTrip;
  bool armed_ = false;
  bool deadMan_ = true;  // pressed as long as it has not been seen released
  bool asked_ = true;
};

}  // namespace haptiv
