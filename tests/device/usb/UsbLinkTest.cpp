/// The link itself, with a client that knows nothing of boards.
#include "device/usb/libusb/UsbLink.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <system_error>

#include "device/usb/host/BoardRequests.h"
#include "device/usb/libusb/UsbFailure.h"
#include "tests/device/usb/bench/BoardOnUsb.h"
#include "tests/support/usb/VirtualBus.h"

namespace haptiv::test {
namespace {

using testing::HasSubstr;

/// Takes any packet, and is made ready as the test says.
class AnyClient : public usb::UsbClient {
 public:
  usb::StreamEndpoints prepare(usb::UsbHandle&) override {
    if (trouble) trouble();
    there = true;
    return {usb::TransferKind::interrupt, usb::kStateEndpoint, 128, 0, 0};
  }
  void received(std::span<const std::uint8_t>) noexcept override { ++packets; }
  void faulted(usb::TransferEnd) noexcept override {}
  std::size_t send(std::span<std::uint8_t>) noexcept override { return 0; }
  void skip() noexcept override {}
  void lost() noexcept override { there = false; }

  std::function<void()> trouble;  ///< changed only while the bus is at rest
  std::atomic<bool> there = false;
  std::atomic<int> packets = 0;
};

class UsbLinkTest : public testing::Test {
 protected:
  void replug() {
    bus.unplug(*port);
    port = &bus.plug(board);
  }

  VirtualBus bus;
  std::shared_ptr<BoardOnUsb> board = std::make_shared<BoardOnUsb>(loadDeviceDescription("vishard10"), "B-0001");
  VirtualPort* port = &bus.plug(board);
  AnyClient client;
  usb::UsbLink link{usb::boardKind(), "", client};
};

TEST_F(UsbLinkTest, WhateverGoesWrongWhenItIsPluggedInAgainIsToldAndTheNextTimeItIsOpened) {
  link.open();
  const std::vector<std::pair<std::function<void()>, std::string>> troubles = {
      {[] { throw usb::UsbFailure(usb::UsbTrouble::silent, "it does not answer"); }, "it does not answer"},
      {[] { throw std::runtime_error("the firmware cannot be read"); }, "the firmware cannot be read"},
      {[] { throw std::system_error(ENFILE, std::generic_category(), "no descriptor left"); }, "no descriptor left"},
      {[] { throw std::bad_alloc(); }, "cannot use the Haptiv interface board"},
      {[] { throw 7; }, "switch it off and on"}};
  for (const auto& [trouble, told] : troubles) {
    client.trouble = trouble;
    replug();
    EXPECT_THAT(link.trouble(), HasSubstr(told));
    EXPECT_FALSE(client.there);
    EXPECT_THROW(link.betweenStreams([](usb::UsbHandle&) {}), usb::UsbFailure) << "nothing is open";
    client.trouble = nullptr;
    replug();
    EXPECT_EQ(link.trouble(), "");
    EXPECT_TRUE(client.there);
    const int before = client.packets;
    bus.tick(3);
    EXPECT_EQ(client.packets, before + 3);
  }
}

TEST_F(UsbLinkTest, WhatGoesWrongAtFirstIsThrownAndLeavesNothingBehind) {
  client.trouble = [] { throw std::runtime_error("the firmware cannot be read"); };
  EXPECT_THROW(link.open(), std::runtime_error);
  client.trouble = nullptr;
  link.open();
  bus.tick(2);
  EXPECT_EQ(client.packets, 2);
}

}  // namespace
}  // namespace haptiv::test
