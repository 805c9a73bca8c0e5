/// The board's safety circuit: what stops the drives, when, and what sets them free again.
#include <gtest/gtest.h>

#include <limits>

#include "tests/device/board/BoardBench.h"

namespace haptiv {
namespace {

struct SafetyCircuit : testing::Test, test::BoardBench {
  /// Turns joint `joint` by `perTick` counts in each of some ticks.
  void turn(int joint, int perTick, int ticks) {
    for (int i = 0; i < ticks; ++i) {
      for (int k = 0; k < 4; ++k) {
        inputs.encoderCounts[joint] += perTick / 4;
        if (k == 0 && hostLives) send();
        look(kTick / 4);
      }
    }
  }
};

TEST_F(SafetyCircuit, StopsTheDrivesTenMillisecondsAfterTheHostFroze) {
  ASSERT_EQ(board.thresholds().watchdogTime, 10'000);
  drive();
  send();
  for (const std::int64_t end = now + 10'000; now < end;) {
    EXPECT_TRUE(drives());
    EXPECT_EQ(board.report().watchdogLeft, end - now);
    look(250);
  }
  look(1);
  EXPECT_FALSE(drives());
  EXPECT_EQ(trips(), kTripWatchdog);
  EXPECT_EQ(board.report().watchdogLeft, 0u);
}

TEST_F(SafetyCircuit, IsNotFedByAHeartbeatThatStandsStill) {
  drive();
  for (int i = 0; i < 11; ++i) {
    ++command.sequence;
    const bool refused = board.accept(command) == Acceptance::sameHeartbeat;
    EXPECT_TRUE(refused);
    look(kTick);
  }
  EXPECT_EQ(trips(), kTripWatchdog);
  ++command.sequence;
  EXPECT_EQ(board.accept(command), Acceptance::sameHeartbeat) << "nor does the old one begin anew";
}

TEST_F(SafetyCircuit, MissesNoHostWhileTheDrivesAreOff) {
  tick(5);
  hostLives = false;
  tick(100);
  hostLives = true;
  drive();
  EXPECT_TRUE(drives());
  EXPECT_EQ(trips(), kNoTrip);
}

TEST_F(SafetyCircuit, StopsAJointThatCountsMoreThanTheReferenceCounter) {
  const int threshold = static_cast<int>(board.thresholds().countThreshold[3]);
  drive();
  turn(3, threshold, 50);
  EXPECT_EQ(trips(), kNoTrip) << "as fast as allowed";
  turn(3, threshold + 4, 2);
  EXPECT_EQ(trips(), kTripOverspeed | tripJoints(1u << 3)) << "four counts more, within two time units";
  EXPECT_FALSE(drives());
}

TEST_F(SafetyCircuit, StopsAFastJointInEitherDirectionAndWithinATimeUnit) {
  for (const int sign : {1, -1}) {
    drive();
    turn(0, sign * 4 * 720, 1);
    EXPECT_EQ(trips(), kTripOverspeed | tripJoints(1u << 0));
    rearm();
    ASSERT_TRUE(drives());
  }
}

TEST_F(SafetyCircuit, CountsImpulsesOfBothDirectionsTogether) {
  drive();
  for (int k = 0; k < 8; ++k) {
    inputs.encoderCounts[5] += k % 2 ? 400 : -400;
    look(250);
  }
  EXPECT_EQ(trips(), kTripOverspeed | tripJoints(1u << 5));
}

TEST_F(SafetyCircuit, AllowsMoreImpulsesWhereItLooksLessOften) {
  drive();
  for (int i = 0; i < 20; ++i) {
    send();
    inputs.encoderCounts[1] += 5 * 700;
    look(5'000);
  }
  EXPECT_EQ(trips(), kNoTrip);
}

TEST_F(SafetyCircuit, SeesNoMotionInACounterThatWraps) {
  inputs.encoderCounts[6] = std::numeric_limits<std::int32_t>::max() - 100;
  drive();
  inputs.encoderCounts[6] = std::numeric_limits<std::int32_t>::min() + 100;
  tick();
  EXPECT_EQ(trips(), kNoTrip);
}

TEST_F(SafetyCircuit, NamesAnEncoderThatJumpsOrIsBroken) {
  drive();
  inputs.encoderCounts[8] += 1 << 20;
  tick();
  EXPECT_EQ(trips(), kTripOverspeed | kTripEncoder | tripJoints(1u << 8));
  rearm();
  ASSERT_TRUE(drives());
  inputs.encoderFaults = 1u << 2;
  tick();
  EXPECT_EQ(trips(), kTripEncoder | tripJoints(1u << 2));
}

TEST_F(SafetyCircuit, StopsAtAnyEmergencyStopAndStaysStoppedWhileItIsPressed) {
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

TEST_F(SafetyCircuit, StopsWhenTheDeadManIsReleasedWhileTheArmIsDriven) {
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

TEST_F(SafetyCircuit, LatchesADeadManWhoseReleaseTheHostDoesNotSee) {
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

TEST_F(SafetyCircuit, LetsTheDeadManGoWhileTheArmIsNotDriven) {
  drive();
  command.drive.enabled = false;
  tick();
  release(kInputDeadMan);
  tick();
  EXPECT_EQ(trips(), kNoTrip);
}

TEST_F(SafetyCircuit, NeverStartsWithADeadManThatIsTiedDown) {
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

TEST_F(SafetyCircuit, IsNotResetWhileTheDeadManIsPressedNorByAButtonThatIsTiedDown) {
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

TEST_F(SafetyCircuit, IsResetByTheHostAsByTheBoardsButton) {
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

TEST_F(SafetyCircuit, StopsWhenTheHostAsksForItOrThePowerFails) {
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

TEST_F(SafetyCircuit, TakesTighterThresholdsButNoLooserOnes) {
  CircuitThresholds wanted = board.thresholds();
  wanted.watchdogTime = 3'000;
  wanted.countThreshold.fill(100);
  EXPECT_TRUE(board.configure(wanted));
  EXPECT_EQ(board.thresholds(), wanted);
  const CircuitThresholds builtFor = board.settings().thresholds;
  for (const auto& loosen :
       {+[](CircuitThresholds& t) { t.watchdogTime += 1; }, +[](CircuitThresholds& t) { t.watchdogTime = 0; },
        +[](CircuitThresholds& t) { t.velocityTimeUnit /= 2; }, +[](CircuitThresholds& t) { t.velocityTimeUnit = -1; },
        +[](CircuitThresholds& t) { t.countThreshold[9] += 1; },
        +[](CircuitThresholds& t) { t.countThreshold[0] = 0; }}) {
    CircuitThresholds loose = builtFor;
    loosen(loose);
    EXPECT_FALSE(board.configure(loose));
    EXPECT_EQ(board.thresholds(), wanted);
  }
  EXPECT_TRUE(board.configure(builtFor));
  drive();
  EXPECT_FALSE(board.configure(builtFor)) << "not while the drives are on";
}

TEST_F(SafetyCircuit, TakesAClockThatRunsBackwardsForOneThatStands) {
  drive();
  send();
  const std::int64_t before = board.report().time;
  board.advance(before - 5'000, inputs);
  EXPECT_EQ(board.report().time, before);
  board.advance(before + 10'001, inputs);
  EXPECT_EQ(trips(), kTripWatchdog);
}

}  // namespace
}  // namespace haptiv
