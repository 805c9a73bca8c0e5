#pragma once

#include <algorithm>
#include <cstdint>

#include "device/described/DeviceDescription.h"
#include "haptics/safety/Clamps.h"
#include "haptics/safety/Faults.h"

namespace haptiv {

/// Finds a virtual mass that runs by itself: for kLongest in a row it is held back by the clamp of speed while the hand
/// does not push it on. A scene that feeds it would show so, or a controller that does.
///
/// A push is more than a hundredth of `forceClamp`, and more than the sensor's noise may look like.
class RunawayMonitor {
 public:
  static constexpr double kLongest = 0.05;  ///< [s]

  RunawayMonitor(const DeviceDescription& description, double period)
      : push_(std::max(0.01 * description.safety.forceClamp, 6 * description.sensor.forceNoise)), period_(period) {}

  /// @param clamps  of the tick before
  /// @param time    out: for how long it has run so [s]
  /// @return        kFaultRunaway, or none
  /// Realtime-safe: yes.
  std::uint32_t operator()(std::uint32_t clamps, const Vector3& velocity, const Vector3& handForce,
                           double& time) const noexcept {
    const bool byItself = (clamps & kClampSpeed) != 0 && handForce.dot(velocity) <= push_ * velocity.norm();
    time = byItself ? time + period_ : 0;
    return time > kLongest ? kFaultRunaway : kNoFault;
  }

 private:
  double push_;  ///< [N]
  double period_;
};

}  // namespace haptiv
