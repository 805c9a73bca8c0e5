#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "device/usb/UsbDevice.h"
#include "tests/device/usb/bench/BoardOnUsb.h"
#include "tests/support/usb/VirtualBus.h"

namespace haptiv::test {

/// A board on a virtual bus, its operator, and a host that ticks at 1 kHz by a clock of the test's own. Whatever
/// befalls the wire, at the end no unsafe set-point has reached the drives.
class UsbBench : public testing::Test {
 protected:
  ~UsbBench() override { EXPECT_EQ(board->unsafe, 0); }

  /// So many ticks of the servo, and of the bus between them.
  void tick(int count = 1) {
    for (int i = 0; i < count; ++i) {
      reading = device.read();
      device.write(command);
      bus.tick(kIntervals);
    }
    reading = device.read();
  }
  /// The host is there and the operator takes the handle: joint 1 turns.
  void drive() {
    device.start(1e-3);
    command.enabled = true;
    command.jointRates[0] = 0.3;
    tick(3);
    grip();
    ASSERT_TRUE(drives());
  }
  void grip() {
    board->buttons = 0;
    tick();
    board->buttons = kInputDeadMan;
    tick(2);
  }
  /// What an operator does after a trip, at the host.
  void resetAtHost() {
    board->buttons = 0;
    tick(2);
    device.press(kInputReset);
    tick(2);
    device.press(0);
    grip();
  }
  void replug() {
    bus.unplug(*port);
    port = &bus.plug(board);
    bus.settle();
  }

  bool drives() const { return !board->board().demand().braked; }
  double setPoint() const { return board->board().demand().setPoints[0]; }
  std::uint32_t trips() const { return board->board().report().reading.trips; }
  usb::LinkFigures figures() const { return device.figures(); }
  /// What it says when it cannot be started; empty where it can.
  static std::string refusalOf(UsbDevice& host) {
    try {
      host.start(1e-3);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  }

  static constexpr int kIntervals = 8;  // of 125 us

  DeviceDescription description = loadDeviceDescription("vishard10");
  std::shared_ptr<BoardOnUsb> board = std::make_shared<BoardOnUsb>(description, "B-0001");
  VirtualBus bus;
  VirtualPort* port = &bus.plug(board);
  UsbDevice device{description, {"", board->countsHere(), false}};
  DeviceCommand command;
  DeviceReading reading;
};

}  // namespace haptiv::test
