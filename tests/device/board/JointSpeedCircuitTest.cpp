/// The board's shut-off by joint velocity, and its thresholds.
#include <gtest/gtest.h>

#include <limits>

#include "tests/device/board/BoardBench.h"

namespace haptiv {
namespace {

struct JointSpeedCircuit : testing::Test, test::BoardBench {
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

TEST_F(JointSpeedCircuit, StopsAJointThatCountsMoreThanTheReferenceCounter) {
  const int threshold = static_cast<int>(board.thresholds().countThreshold[3]);
  drive();
  turn(3, threshold, 50);
  EXPECT_EQ(trips(), kNoTrip) << "as fast as allowed";
  turn(3, threshold + 4, 2);
  EXPECT_EQ(trips(), kTripOverspeed | tripJoints(1u << 3)) << "four counts more, within two time units";
  EXPECT_FALSE(drives());
}

TEST_F(JointSpeedCircuit, StopsAFastJointInEitherDirectionAndWithinATimeUnit) {
  for (const int sign : {1, -1}) {
    drive();
    turn(0, sign * 4 * 720, 1);
    EXPECT_EQ(trips(), kTripOverspeed | tripJoints(1u << 0));
    rearm();
    ASSERT_TRUE(drives());
  }
}

TEST_F(JointSpeedCircuit, CountsImpulsesOfBothDirectionsTogether) {
  drive();
  for (int k = 0; k < 8; ++k) {
    inputs.encoderCounts[5] += k % 2 ? 400 : -400;
    look(250);
  }
  EXPECT_EQ(trips(), kTripOverspeed | tripJoints(1u << 5));
}

TEST_F(JointSpeedCircuit, AllowsMoreImpulsesWhereItLooksLessOften) {
  drive();
  for (int i = 0; i < 20; ++i) {
    send();
    inputs.encoderCounts[1] += 5 * 700;
    look(5'000);
  }
  EXPECT_EQ(trips(), kNoTrip);
}

TEST_F(JointSpeedCircuit, SeesNoMotionInACounterThatWraps) {
  inputs.encoderCounts[6] = std::numeric_limits<std::int32_t>::max() - 100;
  drive();
  inputs.encoderCounts[6] = std::numeric_limits<std::int32_t>::min() + 100;
  tick();
  EXPECT_EQ(trips(), kNoTrip);
}

TEST_F(JointSpeedCircuit, NamesAnEncoderThatJumpsOrIsBroken) {
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

TEST_F(JointSpeedCircuit, TakesTighterThresholdsButNoLooserOnes) {
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

}  // namespace
}  // namespace haptiv
