#pragma once

#include <vector>

#include "device/simulated/Hand.h"
#include "device/simulated/SimulatedDevice.h"
#include "haptics/servo/ServoLoop.h"

namespace haptiv::testing {

/// Lets the dead-man go, presses it, and pulls the handle to and fro.
class PullingHand : public HandSource {
 public:
  explicit PullingHand(const Vector3& home_B) : home_(home_B) {}
  HandTarget at(double time) noexcept override;

 private:
  Vector3 home_;
};

/// Where the handle of an arm at its home angles is, in B [m].
Vector3 homeOf(const DeviceDescription& description);

/// The simulated arm with a PullingHand on it.
SimulatedDevice pulledArm(const DeviceDescription& description);

/// The servo loop itself at 1 kHz for so many ticks, in a crowded scene; every 50 ticks another version of the scene,
/// another strategy and another way of control are handed over, while the log's records are taken out.
std::vector<TickRecord> runServo(HapticDevice& device, const DeviceDescription& description, std::uint64_t ticks);

}  // namespace haptiv::testing
