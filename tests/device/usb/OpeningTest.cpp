/// Which board is opened, and what is said where none can be.
#include <gmock/gmock.h>

#include "device/usb/libusb/UsbFailure.h"
#include "tests/device/usb/bench/UsbBench.h"

namespace haptiv::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

struct Opening : UsbBench {};

TEST_F(Opening, TellsThatThereIsNone) {
  bus.unplug(*port);
  EXPECT_THAT(refusalOf(device), HasSubstr("there is no Haptiv interface board: plug one in"));
}

TEST_F(Opening, NamesTheUdevRuleWhereItIsNotPermitted) {
  port->permitted = false;
  EXPECT_THAT(refusalOf(device), AllOf(HasSubstr("no permission"), HasSubstr("device/usb/60-haptiv.rules")));
}

TEST_F(Opening, TellsThatAnotherProgramHoldsIt) {
  drive();
  UsbDevice other(description);
  EXPECT_THAT(refusalOf(other), HasSubstr("another program holds it"));
  tick(20);
  EXPECT_TRUE(drives()) << "the first host goes on";
}

TEST_F(Opening, TellsWhichVersionTheBoardSpeaks) {
  board->otherVersion = 2;
  EXPECT_THAT(refusalOf(device), AllOf(HasSubstr("speaks version 2"), HasSubstr("update Haptiv")));
  board->otherVersion = 0;
  EXPECT_EQ(refusalOf(device), "");
}

TEST_F(Opening, RefusesABoardOfAnotherArm) {
  UsbDevice other(loadDeviceDescription("anthropomorphic7"));
  EXPECT_THAT(refusalOf(other), AllOf(HasSubstr("'vishard10' of 10 joints"), HasSubstr("'anthropomorphic7'")));
}

TEST_F(Opening, RefusesABoardWithoutAZero) {
  UsbDevice other(description);
  EXPECT_THAT(refusalOf(other), HasSubstr("has not been homed"));
}

TEST_F(Opening, WaitsASecondForABoardThatDoesNotAnswer) {
  port->faults.silentControl = true;
  EXPECT_THAT(refusalOf(device), HasSubstr("does not answer"));
}

TEST_F(Opening, ChoosesAmongSeveralBySerialNumber) {
  auto second = std::make_shared<BoardOnUsb>(description, "B-0002");
  bus.plug(second);
  EXPECT_THAT(refusalOf(device), AllOf(HasSubstr("B-0001"), HasSubstr("B-0002"), HasSubstr("choose one")));
  UsbDevice none(description, {"B-0003", board->countsHere(), false});
  EXPECT_THAT(refusalOf(none), AllOf(HasSubstr("B-0003"), HasSubstr("there is: B-0001, B-0002")));
  UsbDevice chosen(description, {"B-0002", second->countsHere(), false});
  EXPECT_EQ(refusalOf(chosen), "");
  EXPECT_EQ(chosen.serial(), "B-0002");
  EXPECT_TRUE(second->board().homed());
  EXPECT_FALSE(board->board().homed());
}

TEST_F(Opening, TwoBoardsAreDrivenSideBySide) {
  auto second = std::make_shared<BoardOnUsb>(description, "B-0002");
  bus.plug(second);
  UsbDevice other(description, {"B-0002", second->countsHere(), false});
  UsbDevice first(description, {"B-0001", board->countsHere(), false});
  first.start(1e-3);
  other.start(1e-3);
  bus.tick(8);
  EXPECT_TRUE(first.read().connected);
  EXPECT_TRUE(other.read().connected);
}

TEST_F(Opening, TheSameBoardIsFoundAgainInAnyPortAndNoOther) {
  UsbDevice chosen(description, {"B-0001", board->countsHere(), false});
  board->ownSupply = true;
  chosen.start(1e-3);
  bus.unplug(*port);
  bus.plug(std::make_shared<BoardOnUsb>(description, "B-0002"));
  EXPECT_THAT(chosen.trouble(), HasSubstr("B-0001"));
  bus.plug(board);
  EXPECT_EQ(chosen.trouble(), "");
}

TEST_F(Opening, SetsTheThresholdsOfTheDescriptionWhereTheyAreTighter) {
  description.safety.watchdogTime = 0.004;
  UsbDevice tighter(description, {"", board->countsHere(), false});
  tighter.start(1e-3);
  EXPECT_EQ(board->board().thresholds().watchdogTime, 4000);
  tighter.stop();
  description.safety.watchdogTime = 0.1;
  UsbDevice looser(description, {"", std::nullopt, false});
  looser.start(1e-3);
  EXPECT_EQ(board->board().thresholds().watchdogTime, 4000);
}

TEST_F(Opening, AtFullSpeedNoMoreThanAThousandTicksASecond) {
  bus.unplug(*port);
  board = std::make_shared<BoardOnUsb>(description, "B-0001", UsbSpeed::full);
  port = &bus.plug(board);
  EXPECT_THROW(device.start(0.25e-3), usb::UsbFailure);
  EXPECT_EQ(refusalOf(device), "");
  EXPECT_FALSE(device.highSpeed());
}

}  // namespace
}  // namespace haptiv::test
