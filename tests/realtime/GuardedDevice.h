#pragma once

#include <string>

#include "device/HapticDevice.h"
#include "tests/realtime/HiddenCalls.h"
#include "tests/realtime/SyscallTrap.h"

namespace haptiv::testing {

/// Watches the thread that reads it, from its first read to its last: device, tick, hand-over and sleep are in between.
class GuardedDevice : public HapticDevice {
 public:
  explicit GuardedDevice(HapticDevice& device) : device_(device) {}

  void start(double period) override { device_.start(period); }
  void stop() override { device_.stop(); }
  void write(const DeviceCommand& command) noexcept override { device_.write(command); }
  DeviceReading read() noexcept override {
    if (!watching_) {
      watching_ = true;
      whyNoTrap = trapSyscalls();
      caughtBefore_ = caughtSyscalls();
      before_ = hiddenCalls();
    }
    calls = hiddenCalls() - before_;
    syscalls = caughtSyscalls() - caughtBefore_;
    lastSyscall = lastCaughtSyscall();
    return device_.read();
  }

  // For after the loop has stopped.
  HiddenCalls calls;
  std::size_t syscalls = 0;
  int lastSyscall = -1;   ///< its number
  std::string whyNoTrap;  ///< empty: system calls were trapped

 private:
  HapticDevice& device_;
  bool watching_ = false;
  HiddenCalls before_;
  std::size_t caughtBefore_ = 0;
};

}  // namespace haptiv::testing
