#pragma once

#include <cstdint>

#include "device/types.h"
#include "haptics/safety/Clamps.h"
#include "haptics/safety/Faults.h"

namespace haptiv {

/// Finds a virtual mass that runs by itself: for kLongest in a row it is held back by the clamp of speed while the hand
/// does not push it on. A scene that feeds it would show so, or a controller that does.
class RunawayMonitor {
 public:
  static constexpr double kLongest = 0.05;  ///< [s]

  explicit RunawayMonitor(double period) : period_(period) {}

  /// @param clamps  of the tick before
  /// @param time    out: for how long it has run so [s]
  /// @return        kFaultRunaway, or none
  /// Realtime-safe: yes.
  std::uint32_t operator()(std::uint32_t clamps, const Vector3& velocity, const Vector3& handForce,
                           double& time) const noexcept {
    const bool byItself = (clamps & kClampSpeed) != 0 && handForce.dot(velocity) <= 0;
    time = byItself ? time + period_ : 0;
    return time > kLongest ? kFaultRunaway : kNoFault;
  }

 private:
  double period_;
};

}  // namespace haptiv
