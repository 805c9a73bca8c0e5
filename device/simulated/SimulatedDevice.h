#pragma once

#include <cstdint>
#include <memory>

#include "device/DeviceDescription.h"
#include "device/HapticDevice.h"
#include "device/simulated/Hand.h"

namespace haptiv {

/// An arm, its drives, its sensors and an operator's hand, in place of the hardware; deterministic for a given seed.
/// The servo code cannot tell it from a real device.
class SimulatedDevice : public HapticDevice {
 public:
  /// @param start  joint angles at which the encoders are and the session begins [rad]
  SimulatedDevice(const DeviceDescription& description, const JointVector& start, std::unique_ptr<HandSource> hand,
                  std::uint64_t seed);
  ~SimulatedDevice() override;

  void start(double period) override;
  DeviceReading read() noexcept override;
  void write(const DeviceCommand& command) noexcept override;
  void stop() override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
