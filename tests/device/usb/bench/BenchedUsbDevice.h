#pragma once

#include <memory>

#include "device/usb/UsbDevice.h"
#include "tests/device/usb/bench/BoardOnUsb.h"
#include "tests/support/usb/VirtualBus.h"

namespace haptiv::test {

/// A UsbDevice over the virtual bus, whose clock is the servo's: each write lets one period pass on the bus. A start
/// begins anew, with the arm at home and a board that has just been switched on. The operator holds the dead-man from
/// the first write on.
class BenchedUsbDevice : public HapticDevice {
 public:
  /// @param hand  null: nobody at the handle, the dead-man's button held down by other means
  BenchedUsbDevice(const DeviceDescription& description, UsbSpeed speed, std::unique_ptr<HandSource> hand = nullptr)
      : description_(description), speed_(speed), hand_(std::move(hand)) {}

  void start(double period) override {
    plug();
    if (!device_)
      device_ = std::make_unique<UsbDevice>(description_, UsbDeviceChoice{"BENCH-1", board_->countsHere(), false});
    device_->start(period);
    intervals_ = static_cast<int>(std::lround(period * 1e6 / static_cast<double>(port_->interval())));
    bus_.tick(intervals_);
    period_ = period;
    ticks_ = 0;
    running_ = true;
  }
  DeviceReading read() noexcept override { return device_ ? device_->read() : DeviceReading{}; }
  void write(const DeviceCommand& command) noexcept override {
    if (!running_) return;
    board_->hand = hand_ ? hand_->at(static_cast<double>(ticks_++) * period_) : HandTarget{};
    board_->buttons = board_->hand.inputs;
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

  Homing* homing() noexcept override { return device_ ? device_->homing() : nullptr; }

  BoardOnUsb& board() { return *board_; }
  VirtualPort& port() { return *port_; }
  VirtualBus& bus() { return bus_; }

 private:
  void plug() {
    if (port_ != nullptr) bus_.unplug(*port_);
    board_ = std::make_shared<BoardOnUsb>(description_, "BENCH-1", speed_);
    port_ = &bus_.plug(board_);
  }

  DeviceDescription description_;
  UsbSpeed speed_;
  VirtualBus bus_;
  std::shared_ptr<BoardOnUsb> board_;
  VirtualPort* port_ = nullptr;
  std::unique_ptr<UsbDevice> device_;
  std::unique_ptr<HandSource> hand_;
  double period_ = 0;       // of the servo [s]
  std::int64_t ticks_ = 0;  // since the start
  int intervals_ = 8;       // of the bus in a tick
  bool running_ = false;
};

}  // namespace haptiv::test
