#pragma once

#include <cstddef>
#include <vector>

#include "device/HapticDevice.h"

namespace haptiv {

/// Gives readings that were recorded, one a tick, and takes commands without an effect: what is left is the host's
/// side.
class ReplayedDevice : public HapticDevice {
 public:
  /// @param readings  at least one; the last one is given for ever
  explicit ReplayedDevice(std::vector<DeviceReading> readings) : readings_(std::move(readings)) {}

  void start(double) override { next_ = 0; }
  DeviceReading read() noexcept override { return readings_[next_]; }
  void write(const DeviceCommand& command) noexcept override {
    command_ = command;
    if (next_ + 1 < readings_.size()) ++next_;
  }
  void stop() override {}

 private:
  std::vector<DeviceReading> readings_;
  DeviceCommand command_;
  std::size_t next_ = 0;
};

}  // namespace haptiv
