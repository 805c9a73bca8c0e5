#pragma once

#include <cstdint>
#include <memory>

#include "device/DeviceDescription.h"
#include "device/HapticDevice.h"
#include "device/simulated/Hand.h"

namespace haptiv {

/// An arm, its drives, its sensors and an operator's hand, in place of the hardware; deterministic for a given seed.
/// The servo code cannot tell it from a real device.
///
/// Its time is the servo's: a write advances it by one period, with the set-points held. A start begins anew.
class SimulatedDevice : public HapticDevice {
 public:
  /// @param start  joint angles at which the arm stands and the session begins [rad], rounded to encoder counts
  /// @param hand   null: nobody at the handle
  /// Throws std::runtime_error where an angle is not finite.
  SimulatedDevice(const DeviceDescription& description, const JointVector& start, std::unique_ptr<HandSource> hand,
                  std::uint64_t seed);
  ~SimulatedDevice() override;

  /// Throws std::runtime_error unless 0 < period <= 0.1.
  void start(double period) override;
  DeviceReading read() noexcept override;
  void write(const DeviceCommand& command) noexcept override;
  void stop() override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
