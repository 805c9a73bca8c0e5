/// What is found on a virtual bus by real libusb, and in what state.
#include "device/usb/PluggedDevices.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <optional>

#include "device/usb/spacemouse/SpaceMouse.h"
#include "tests/device/usb/bench/BoardOnUsb.h"
#include "tests/device/usb/falcon/BenchedFalcon.h"
#include "tests/device/usb/spacemouse/VirtualSpaceMouse.h"
#include "tests/support/usb/VirtualBus.h"

namespace haptiv::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class Plugged : public testing::Test {
 protected:
  ~Plugged() override { std::filesystem::remove(firmware_); }

  VirtualPort& plugBoard(const std::string& serial) {
    board_ = std::make_shared<BoardOnUsb>(arm_, serial);
    return bus_.plug(board_);
  }
  VirtualPort& plugFalcon() { return bus_.plug(std::make_shared<falcon::test::FalconOnUsb>(falconArm_)); }
  VirtualPort& plugMouse() { return bus_.plug(std::make_shared<VirtualSpaceMouse>(0x256f, 0xc635)); }
  std::vector<PluggedDevice> list() { return pluggedDevices(firmware_); }
  PluggedDevice only() {
    const std::vector<PluggedDevice> all = list();
    EXPECT_THAT(all, SizeIs(1));
    return all.at(0);
  }
  void supplyFirmware(std::size_t size = 4096) {
    std::ofstream(firmware_, std::ios::binary) << std::string(size, '\x7f');
  }

  DeviceDescription arm_ = loadDeviceDescription("vishard10"), falconArm_ = loadDeviceDescription("falcon");
  std::filesystem::path firmware_ =
      std::filesystem::temp_directory_path() / ("haptiv-plugged-" + std::to_string(::getpid()) + ".bin");
  VirtualBus bus_;
  std::shared_ptr<BoardOnUsb> board_;
};

TEST_F(Plugged, NothingIsAnEmptyList) {
  EXPECT_THAT(list(), IsEmpty());
}

TEST_F(Plugged, AllKindsStandInOneListWithNamesToChooseThemBy) {
  supplyFirmware();
  plugMouse();
  plugFalcon();
  plugBoard("B-0001");
  const std::vector<PluggedDevice> all = list();
  ASSERT_THAT(all, SizeIs(3));
  EXPECT_EQ(all[0].name(), "usb:B-0001");
  EXPECT_EQ(all[0].port, "1-4");
  EXPECT_TRUE(all[0].highSpeed);
  EXPECT_EQ(all[1].name(), "falcon:FALCON-1");
  EXPECT_EQ(all[1].state, PluggedState::usable) << all[1].trouble;
  EXPECT_EQ(all[2].name(), "spacemouse:1-2") << "it has no serial number";
  EXPECT_EQ(all[2].product, "SpaceMouse Compact");
  EXPECT_EQ(all[2].state, PluggedState::usable) << all[2].trouble;
}

TEST_F(Plugged, OfTwoWithOneSerialNumberEachIsNamedByItsPort) {
  plugBoard("B-0001");
  plugBoard("B-0001");
  const std::vector<PluggedDevice> all = list();
  ASSERT_THAT(all, SizeIs(2));
  EXPECT_EQ(all[0].name(), "usb:1-2");
  EXPECT_EQ(all[1].name(), "usb:1-3");
}

TEST_F(Plugged, WithoutPermissionTheRuleIsNamed) {
  for (VirtualPort* port : {&plugBoard("B-0001"), &plugFalcon(), &plugMouse()}) port->permitted = false;
  for (const PluggedDevice& device : list()) {
    EXPECT_EQ(device.state, PluggedState::noPermission) << device.name();
    EXPECT_THAT(device.trouble, HasSubstr("device/usb/60-haptiv.rules")) << device.name();
    EXPECT_EQ(device.which, device.port) << "its serial number cannot be read";
  }
}

TEST_F(Plugged, TellsWhatAnotherProgramHolds) {
  plugMouse();
  const SpaceMouse other;
  EXPECT_EQ(only().state, PluggedState::held);
  EXPECT_THAT(only().trouble, HasSubstr("close that one first"));
}

TEST_F(Plugged, AFalconWantsItsFirmware) {
  plugFalcon();
  EXPECT_EQ(only().state, PluggedState::firmwareMissing);
  EXPECT_THAT(only().trouble, AllOf(HasSubstr(firmware_.string()), HasSubstr("--firmware")));
  supplyFirmware(100);
  EXPECT_EQ(only().state, PluggedState::firmwareMissing) << "too short to be one";
  supplyFirmware();
  EXPECT_EQ(only().state, PluggedState::usable);
}

TEST_F(Plugged, ABoardTellsWhetherItIsHomedAndWhatItSpeaks) {
  plugBoard("B-0001");
  EXPECT_EQ(only().state, PluggedState::notHomed);
  EXPECT_THAT(only().trouble, HasSubstr("haptiv device home --device usb:B-0001"));
  board_->otherVersion = 2;
  EXPECT_EQ(only().state, PluggedState::unusable);
  EXPECT_THAT(only().trouble, HasSubstr("speaks version 2"));
}

TEST_F(Plugged, ThoseThatDoNotAnswerAreToldAndHideNoOther) {
  plugBoard("B-0001").faults.silentControl = true;
  plugBoard("B-0002");
  plugBoard("B-0003").faults.silentControl = true;
  plugMouse();
  const std::vector<PluggedDevice> all = list();
  ASSERT_THAT(all, SizeIs(4));
  for (const std::size_t silent : {0, 2}) {
    EXPECT_EQ(all[silent].state, PluggedState::silent);
    EXPECT_EQ(all[silent].name(), "usb:" + all[silent].port);
    EXPECT_THAT(all[silent].trouble, HasSubstr("switch it off and on"));
  }
  EXPECT_EQ(all[1].state, PluggedState::notHomed);
  EXPECT_EQ(all[3].state, PluggedState::usable);
}

TEST_F(Plugged, LookingLeavesNothingOpen) {
  plugMouse();
  list();
  EXPECT_NO_THROW(SpaceMouse());
}

}  // namespace
}  // namespace haptiv::test
