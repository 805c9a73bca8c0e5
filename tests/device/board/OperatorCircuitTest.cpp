/// What the operator stops the drives with, and what sets them free again.
#include <gtest/gtest.h>

#include "tests/device/board/BoardBench.h"

namespace haptiv {
namespace {

struct OperatorCircuit : testing::Test, test::BoardBench {};

TEST_F(OperatorCircuit, StopsAtAnyEmergencyStopAndStaysStoppedWhileItIsPressed) {
  for (const auto stop : {kInputEmergencyStop1, kInputEmergencyStop2, kInputEmergencyStop3, kInputEmergencyStop4}) {
    drive();
    ASSERT_TRUE(drives());
    press(stop);
    tick();
    EXPECT_FALSE(drives());
    rearm();
    EXPECT_FALSE(drives()) << "still pressed";
    EXPECT_EQ(trips(), kTripEmergencyStop);
    release(stop);
    tick();
    EXPECT_EQ(trips(), kTripEmergencyStop) << "latched";
    rearm();
    EXPECT_TRUE(drives());
  }
}

TEST_F(OperatorCircuit, StopsWhenTheDeadManIsReleasedWhileTheArmIsDriven) {
  drive();
  release(kInputDeadMan);
  look(250);
  EXPECT_FALSE(drives());
  EXPECT_EQ(trips(), kNoTrip);
  command.drive.enabled = false;  // the host has seen it
  tick(50);
  EXPECT_EQ(trips(), kNoTrip);
  press(kInputDeadMan);
  tick();
  command.drive.enabled = true;
  tick();
  EXPECT_TRUE(drives());
}

TEST_F(OperatorCircuit, LatchesADeadManWhoseReleaseTheHostDoesNotSee) {
  drive();
  release(kInputDeadMan);
  tick(20);
  EXPECT_FALSE(drives());
  EXPECT_EQ(trips(), kTripDeadMan);
  press(kInputDeadMan);
  tick();
  EXPECT_FALSE(drives()) << "not without a reset";
  rearm();
  EXPECT_TRUE(drives());
}

TEST_F(OperatorCircuit, LetsTheDeadManGoWhileTheArmIsNotDriven) {
  drive();
  command.drive.enabled = false;
  tick();
  release(kInputDeadMan);
  tick();
  EXPECT_EQ(trips(), kNoTrip);
}

TEST_F(OperatorCircuit, NeverStartsWithADeadManThatIsTiedDown) {
  press(kInputDeadMan);
  command.drive.enabled = true;
  tick(10);
  EXPECT_FALSE(drives());
  release(kInputDeadMan);
  tick();
  press(kInputDeadMan);
  tick();
  EXPECT_TRUE(drives());
}

TEST_F(OperatorCircuit, IsNotResetWhileTheDeadManIsPressedNorByAButtonThatIsTiedDown) {
  drive();
  press(kInputEmergencyStop1);
  tick();
  release(kInputEmergencyStop1);
  press(kInputReset);
  tick();
  EXPECT_EQ(trips(), kTripEmergencyStop) << "the dead-man is pressed";
  release(kInputDeadMan);
  tick(5);
  EXPECT_EQ(trips(), kTripEmergencyStop) << "the reset has been pressed before";
  rearm();
  EXPECT_EQ(trips(), kNoTrip);
}

TEST_F(OperatorCircuit, IsResetByTheHostAsByTheBoardsButton) {
  drive();
  press(kInputEmergencyStop1);
  tick();
  release(kInputEmergencyStop1 | kInputDeadMan);
  command.reset = true;
  tick();
  EXPECT_EQ(trips(), kNoTrip);
  EXPECT_FALSE(drives()) << "the dead-man is to be pressed first";
  press(kInputDeadMan);
  tick();
  EXPECT_TRUE(drives());
  command.drive.jointRates.setZero();
  press(kInputEmergencyStop1);
  tick();
  release(kInputEmergencyStop1 | kInputDeadMan);
  tick(5);
  EXPECT_EQ(trips(), kTripEmergencyStop) << "a host that always asks resets once";
}

TEST_F(OperatorCircuit, StopsWhenTheHostAsksForItOrThePowerFails) {
  drive();
  command.trip = true;
  send();
  EXPECT_FALSE(drives());
  EXPECT_EQ(trips(), kTripHost);
  command.trip = false;
  rearm();
  ASSERT_TRUE(drives());
  inputs.powerGood = false;
  tick();
  EXPECT_EQ(trips(), kTripPower);
}

}  // namespace
}  // namespace haptiv
