/// The board's watchdog: a host that does not speak stops the drives.
#include <gtest/gtest.h>

#include "tests/device/board/BoardBench.h"

namespace haptiv {
namespace {

struct WatchdogCircuit : testing::Test, test::BoardBench {};

TEST_F(WatchdogCircuit, StopsTheDrivesTenMillisecondsAfterTheHostFroze) {
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

TEST_F(WatchdogCircuit, IsNotFedByAHeartbeatThatStandsStill) {
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

TEST_F(WatchdogCircuit, MissesNoHostWhileTheDrivesAreOff) {
  tick(5);
  hostLives = false;
  tick(100);
  hostLives = true;
  drive();
  EXPECT_TRUE(drives());
  EXPECT_EQ(trips(), kNoTrip);
}

TEST_F(WatchdogCircuit, TakesAClockThatRunsBackwardsForOneThatStands) {
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
