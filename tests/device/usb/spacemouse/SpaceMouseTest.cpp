/// A SpaceMouse over real libusb and a virtual bus.
#include "device/usb/spacemouse/SpaceMouse.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/device/usb/spacemouse/VirtualSpaceMouse.h"
#include "tests/support/usb/VirtualBus.h"

namespace haptiv::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string troubleOfOpening(const std::string& which = {}) {
  try {
    SpaceMouse mouse(which);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

class SpaceMouseOverUsb : public testing::Test {
 protected:
  VirtualPort& plug(std::uint16_t vendor = 0x046d, std::uint16_t product = 0xc626) {
    mouse_ = std::make_shared<VirtualSpaceMouse>(vendor, product);
    return bus_.plug(mouse_);
  }
  void say(const Bytes& report) {
    mouse_->reports.push_back(report);
    bus_.tick();
  }

  VirtualBus bus_;
  std::shared_ptr<VirtualSpaceMouse> mouse_;
};

TEST_F(SpaceMouseOverUsb, TellsItsAxesAndButtons) {
  plug();
  SpaceMouse mouse;
  EXPECT_TRUE(mouse.newest().connected);
  EXPECT_EQ(mouse.newest().axes, (std::array<std::int16_t, 6>{}));
  say({1, 0x5e, 0x01, 0, 0, 0xa2, 0xfe});
  say({2, 1, 0, 2, 0, 3, 0});
  say({3, 1, 0, 0, 0});
  const SpaceMouseState state = mouse.newest();
  EXPECT_EQ(state.axes, (std::array<std::int16_t, 6>{350, 0, -350, 1, 2, 3}));
  EXPECT_EQ(state.buttons, 1u);
  EXPECT_GT(state.time, 0);
}

TEST_F(SpaceMouseOverUsb, TheWirelessOneIsKnownToo) {
  plug(0x256f, 0xc62f);
  SpaceMouse mouse;
  say({1, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0});
  EXPECT_EQ(mouse.newest().axes, (std::array<std::int16_t, 6>{1, 2, 3, 4, 5, 6}));
}

TEST_F(SpaceMouseOverUsb, StrangeReportsAndLineFaultsChangeNothing) {
  VirtualPort& port = plug();
  SpaceMouse mouse;
  say({1, 9, 0, 9, 0, 9, 0});
  for (const Bytes& strange : {Bytes{}, Bytes{1}, Bytes{1, 2, 3}, Bytes{0x17, 80}, Bytes(16, 0xff)}) say(strange);
  port.faults.damage = 1;
  bus_.tick();
  port.faults.stallIn = 1;
  bus_.tick(2);
  EXPECT_EQ(mouse.newest().axes, (std::array<std::int16_t, 6>{9, 9, 9, 0, 0, 0}));
  EXPECT_EQ(mouse.newest().reports, 1u);
  EXPECT_GE(mouse.newest().ignored, 5u);
  say({1, 8, 0, 8, 0, 8, 0});
  EXPECT_EQ(mouse.newest().axes[0], 8) << "it goes on";
}

TEST_F(SpaceMouseOverUsb, UnpluggedItIsAtRestAndPluggedInAgainItGoesOn) {
  VirtualPort& port = plug();
  SpaceMouse mouse;
  say({1, 0x5e, 0x01, 0, 0, 0, 0});
  say({3, 1});
  bus_.unplug(port);
  const SpaceMouseState gone = mouse.newest();
  EXPECT_FALSE(gone.connected);
  EXPECT_EQ(gone.axes, (std::array<std::int16_t, 6>{}));
  EXPECT_EQ(gone.buttons, 0u);
  plug();
  EXPECT_TRUE(mouse.newest().connected);
  EXPECT_EQ(mouse.newest().buttons, 0u) << "pressed anew, or not at all";
  say({3, 1});
  EXPECT_EQ(mouse.newest().buttons, 1u);
}

TEST_F(SpaceMouseOverUsb, OneOfTwoIsChosenByItsPort) {
  plug();
  const std::shared_ptr<VirtualSpaceMouse> first = mouse_;
  VirtualPort& port = plug();
  EXPECT_THAT(troubleOfOpening(), AllOf(HasSubstr("choose one"), HasSubstr("1-2, 1-3")));
  EXPECT_THAT(troubleOfOpening("1-7"), AllOf(HasSubstr("1-7"), HasSubstr("there is: 1-2, 1-3")));
  SpaceMouse mouse("1-3");
  first->reports.push_back({1, 1, 0, 1, 0, 1, 0});
  say({1, 2, 0, 2, 0, 2, 0});
  EXPECT_EQ(mouse.newest().axes[0], 2);
  bus_.unplug(port);
  EXPECT_FALSE(mouse.newest().connected) << "the other one is not taken in its place";
}

TEST_F(SpaceMouseOverUsb, SaysWhatIsWrong) {
  EXPECT_THAT(troubleOfOpening(), HasSubstr("SpaceMouse"));
  plug().permitted = false;
  EXPECT_THAT(troubleOfOpening(), HasSubstr("udev"));
}

}  // namespace
}  // namespace haptiv::test
