/// What the operator of a Falcon does at the host: stops it, resets it, gives up homing it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/device/usb/falcon/BenchedFalcon.h"

namespace haptiv::falcon::test {
namespace {

class FalconHost : public testing::Test {
 protected:
  static constexpr double kTick = 1e-3;

  DeviceReading push(int ticks) {
    DeviceCommand command;
    command.enabled = true;
    command.mode = DriveMode::torque;
    command.jointTorques.head<3>().setConstant(0.05);
    for (int i = 0; i < ticks; ++i) bench_.write(command);
    return bench_.read();
  }
  bool isStill() { return bench_.falcon().lastOrder().motors == Order{}.motors; }

  BenchedFalcon bench_{loadDeviceDescription("falcon")};
};

TEST_F(FalconHost, AnEmergencyStopTakesTheTorqueAwayWhateverTheServoAsks) {
  bench_.start(kTick);
  push(5);
  ASSERT_FALSE(isStill());
  bench_.device().press(kInputEmergencyStop1);
  EXPECT_EQ(push(3).inputs, kInputDeadMan | kInputEmergencyStop1);
  EXPECT_TRUE(isStill());
  bench_.device().press(kInputReset);
  EXPECT_EQ(push(3).inputs, kInputDeadMan | kInputReset);
  EXPECT_FALSE(isStill()) << "whether it goes on is for the session to say";
}

TEST_F(FalconHost, TheDeadManIsAtTheGripAlone) {
  bench_.buttons = 0;
  bench_.start(kTick);
  bench_.device().press(kInputDeadMan);
  EXPECT_EQ(push(5).inputs, 0);
  EXPECT_TRUE(isStill());
}

TEST_F(FalconHost, HomingCanBeGivenUp) {
  bool asked = false;
  bench_.cancelled = [&] { return asked; };
  bench_.beforePlugging = [](VirtualFalcon& falcon) { falcon.faults().homesByItself = false; };
  bench_.tell = [&](const std::string&) { asked = true; };
  EXPECT_THROW(bench_.start(kTick), std::runtime_error);
  EXPECT_FALSE(bench_.read().connected);
}

}  // namespace
}  // namespace haptiv::falcon::test
