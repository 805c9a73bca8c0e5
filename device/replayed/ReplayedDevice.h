#pragma once

#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "device/HapticDevice.h"

namespace haptiv {

/// Gives readings that were recorded, one a tick, and takes commands without an effect: what is left is the host's
/// side. A start begins anew.
class ReplayedDevice : public HapticDevice {
 public:
  /// @param readings  at least one; the last one is given for ever
  explicit ReplayedDevice(std::vector<DeviceReading> readings) : readings_(std::move(readings)) {}

  /// Throws std::runtime_error unless the period is positive.
  void start(double period) override {
    if (!(period > 0)) throw std::runtime_error("a recording is replayed tick by tick: choose a rate above 0");
    next_ = 0;
    running_ = true;
  }
  DeviceReading read() noexcept override { return readings_[next_]; }
  void write(const DeviceCommand& command) noexcept override {
    command_ = command;
    if (running_ && next_ + 1 < readings_.size()) ++next_;
  }
  void stop() override { running_ = false; }

 private:
  std::vector<DeviceReading> readings_;
  DeviceCommand command_;
  std::size_t next_ = 0;
  bool running_ = false;
};

}  // namespace haptiv
