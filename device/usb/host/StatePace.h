#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>

#include "device/usb/protocol/StreamFrames.h"

namespace haptiv::usb {

/// How a link takes a board's states.
struct StatePace {
  int ahead = 4;                      ///< transfers that are on their way for them
  std::chrono::microseconds rest{0};  ///< after a command, in which they gather
};

/// The board may send eight states a tick at 1 kHz; the servo reads the newest. So they gather until shortly before it
/// reads again: kBefore the end of its period, counted from its command, which leaves time for the thread to wake up.
/// Each state from there on is taken as it comes, that the servo's is as new as can be.
///
/// @param period  of the servo [s]
inline StatePace statePace(double period, FrameForm form) noexcept {
  constexpr double kBefore = 110;    // [us]
  constexpr double kLeast = 250;     // [us]: for less it is not worth it
  constexpr double kLongest = 3000;  // [us]; then each is taken as it comes until the next command
  const double interval = form == FrameForm::full ? 125 : 1000;  // [us]
  const double rest = std::min(1e6 * period - kBefore, kLongest);
  StatePace pace;
  if (rest < std::max(kLeast, 2 * interval)) return pace;
  pace.ahead += static_cast<int>(std::ceil(rest / interval));
  pace.rest = std::chrono::microseconds(std::lround(rest));
  return pace;
}

}  // namespace haptiv::usb
