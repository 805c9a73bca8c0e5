#pragma once

#include "device/described/DeviceDescription.h"
#include "haptics/measuring/Measured.h"
#include "haptics/safety/Faults.h"

namespace haptiv {

/// Keeps the tool within `safety.speedClamp`, whatever moves it: brakes before it gets there.
///
/// Between the speed that is sent at the most (Clamps::kSentShare) and the clamp: drives that follow never come here.
/// What is left to the clamp is for the ticks until the arm brakes: 0.1 m/s of 1.5, in which a hand of 170 N that
/// drives the bare arm gains 35 m/s^2.
class ToolSpeedMonitor {
 public:
  static constexpr double kShare = 0.93;  ///< of speedClamp

  explicit ToolSpeedMonitor(const DeviceDescription& description) : most_(kShare * description.safety.speedClamp) {}

  /// kFaultToolSpeed, or none. Realtime-safe: yes.
  std::uint32_t operator()(const Measured& measured) const noexcept {
    const double speed = (measured.arm.J_BT.topRows<3>() * measured.rates).norm();
    return speed > most_ ? kFaultToolSpeed : kNoFault;
  }

 private:
  double most_;  ///< of the tool at the device [m/s]
};

}  // namespace haptiv
