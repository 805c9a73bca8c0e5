#pragma once

#include <memory>

#include "device/usb/UsbDevice.h"
#include "tests/device/usb/bench/VirtualBoard.h"
#include "tests/support/usb/VirtualBus.h"

namespace haptiv::test {

/// A UsbDevice over the virtual bus, whose clock is the servo's: each write lets one period pass on the bus. A start
/// begins anew, with the arm at home and a board that has just been switched on. The operator holds the dead-man from
/// the first write on.
class BenchedUsbDevice : public HapticDevice {
 public:
  BenchedUsbDevice(const DeviceDescription& description, UsbSpeed speed) : description_(description), speed_(speed) {}

  void start(double period) override {
    plug();
    if (!device_)
      device_ = std::make_unique<UsbDevice>(description_, UsbDeviceChoice{"BENCH-1", board_->countsHere(), false});
    device_->start(period);
    intervals_ = static_cast<int>(std::lround(period * 1e6 / static_cast<double>(port_->interval())));
    bus_.tick(intervals_);
    running_ = true;
  }
  DeviceReading read() noexcept override { return device_ ? device_->read() : DeviceReading{}; }
  void write(const DeviceCommand& command) noexcept override {
    if (!running_) return;
    board_->buttons = kInputDeadMan;
    device_->write(command);
    bus_.tick(intervals_);
  }
  void stop() override {
    if (!running_) return;
    write({});
    bus_.tick(2 * intervals_);
    device_->stop();
    running_ = false;
    board_->buttons = 0;
  }

  VirtualBoard& board() { return *board_; }
  VirtualPort& port() { return *port_; }
  VirtualBus& bus() { return bus_; }

 private:
  void plug() {
    if (port_ != nullptr) bus_.unplug(*port_);
    board_ = std::make_shared<VirtualBoard>(description_, "BENCH-1", speed_);
    port_ = &bus_.plug(board_);
  }

  DeviceDescription description_;
  UsbSpeed speed_;
  VirtualBus bus_;
  std::shared_ptr<VirtualBoard> board_;
  VirtualPort* port_ = nullptr;
  std::unique_ptr<UsbDevice> device_;
  int intervals_ = 8;
  bool running_ = false;
};

}  // namespace haptiv::test
