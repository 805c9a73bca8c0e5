/// What befalls the link as a whole: each case ends in the state that docs/usb.md names.
#include <thread>

#include "tests/device/usb/bench/UsbBench.h"
#include "tests/support/Random.h"

namespace haptiv::test {
namespace {

using testing::HasSubstr;

struct LinkFaults : UsbBench {};

TEST_F(LinkFaults, UnpluggedInFlightIsALatchedLossAndNoSetPoint) {
  drive();
  bus.unplug(*port);
  tick(3);
  EXPECT_FALSE(reading.connected);
  EXPECT_EQ(figures().losses, 1u);
  EXPECT_THAT(device.trouble(), HasSubstr("B-0001"));
  EXPECT_FALSE(drives());
  const std::uint64_t sent = figures().sent;
  tick(10);
  EXPECT_EQ(figures().sent, sent);
}

TEST_F(LinkFaults, ABoardThatLostItsZeroIsHomedAnewBeforeAnythingMoves) {
  drive();
  replug();
  board->buttons = kInputDeadMan;
  tick(20);
  EXPECT_EQ(device.trouble(), "");
  EXPECT_FALSE(reading.connected) << "its counts mean nothing";
  EXPECT_FALSE(drives());
  device.home(board->countsHere());
  tick(20);
  EXPECT_TRUE(reading.connected);
  EXPECT_FALSE(drives()) << "the operator has not let go of the dead-man";
  grip();
  EXPECT_TRUE(drives());
}

TEST_F(LinkFaults, ABoardWithASupplyOfItsOwnWaitsForTheOperatorAlone) {
  drive();
  board->ownSupply = true;
  bus.unplug(*port);
  board->advance(11'000);
  EXPECT_FALSE(drives()) << "its own watchdog";
  port = &bus.plug(board);
  tick(20);
  EXPECT_TRUE(reading.connected);
  EXPECT_EQ(reading.trips, kTripWatchdog);
  EXPECT_FALSE(drives());
  resetAtHost();
  EXPECT_TRUE(drives());
}

TEST_F(LinkFaults, ALossIsToldEvenIfTheBoardIsBackWithinATick) {
  board->ownSupply = true;
  drive();
  reading = device.read();
  ASSERT_TRUE(reading.connected);
  replug();
  bus.tick(kIntervals);
  EXPECT_FALSE(device.read().connected);
}

TEST_F(LinkFaults, UnpluggedWhileItIsOpenedIsToldAndLeavesNothingBehind) {
  for (int request = 1; request < 12; ++request) {
    port->faults.leaveAtControl = request;
    const std::string refusal = refusalOf(device);
    if (port->plugged()) {  // it takes fewer requests than that
      EXPECT_GT(request, 4);
      EXPECT_EQ(refusal, "");
      break;
    }
    EXPECT_FALSE(refusal.empty()) << "request " << request;
    EXPECT_FALSE(drives());
    bus.unplug(*port);
    port = &bus.plug(board);
  }
  tick(5);
  EXPECT_TRUE(reading.connected);
}

TEST_F(LinkFaults, ASilentBoardRampsTheSetPointToZeroAndIsDisabled) {
  drive();
  tick(5);
  port->faults.lose = 1'000'000;  // its states alone: what is sent to it still comes
  std::vector<double> setPoints;
  for (int i = 0; i < 14; ++i) {
    tick();
    setPoints.push_back(drives() ? setPoint() : -1);
  }
  EXPECT_DOUBLE_EQ(setPoints[1], 0.3);
  for (int i = 3; i < 9; ++i) EXPECT_LT(setPoints[i], setPoints[i - 1]) << i;
  EXPECT_GT(setPoints[5], 0);
  EXPECT_EQ(setPoints[11], -1);
  EXPECT_FALSE(reading.connected);
  EXPECT_EQ(trips(), kNoTrip) << "the host was faster than the watchdog";
  port->faults.lose = 0;
  tick(3);
  EXPECT_TRUE(reading.connected);
}

TEST_F(LinkFaults, AFrozenBoardIsDisconnectedUntilItAnswersAgain) {
  drive();
  port->faults.frozen = true;
  tick(12);
  EXPECT_FALSE(reading.connected);
  EXPECT_GT(figures().skipped, 0u);
  port->faults.frozen = false;
  tick(3);
  EXPECT_TRUE(reading.connected);
  EXPECT_EQ(figures().losses, 0u);
}

TEST_F(LinkFaults, AFrozenHostIsBrakedByTheBoardAlone) {
  drive();
  bus.tick(11 * kIntervals);
  EXPECT_FALSE(drives());
  EXPECT_EQ(trips(), kTripWatchdog);
  tick(20);
  EXPECT_EQ(reading.trips, kTripWatchdog);
  EXPECT_FALSE(drives());
  resetAtHost();
  EXPECT_TRUE(drives());
}

TEST_F(LinkFaults, AnEmergencyStopAtTheHostTripsTheBoard) {
  drive();
  device.press(kInputEmergencyStop1);
  tick(2);
  EXPECT_FALSE(drives());
  EXPECT_EQ(trips() & kTripHost, kTripHost);
}

TEST_F(LinkFaults, SetPointsThatAreNoNumbersTripTheBoard) {
  drive();
  command.jointRates[3] = std::numeric_limits<double>::quiet_NaN();
  tick(2);
  EXPECT_FALSE(drives());
  EXPECT_EQ(trips(), kTripCommand);
}

TEST_F(LinkFaults, SetPointsBeyondTheLimitsAreCut) {
  drive();
  command.jointRates.setConstant(1000);
  tick(1);
  EXPECT_GT(board->board().report().counters.clamped, 0u);
}

TEST_F(LinkFaults, StoppingBrakesWithoutATrip) {
  drive();
  std::thread clock([&] {
    for (int i = 0; i < 16; ++i) bus.step();
  });
  command = {};
  tick(2);
  clock.join();
  device.stop();
  EXPECT_FALSE(drives());
  EXPECT_EQ(trips(), kNoTrip);
}

/// Faults of every kind, by chance, while the operator resets again and again.
TEST_F(LinkFaults, InAStormOfFaultsNothingUnsafeIsAccepted) {
  drive();
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    LineFaults& f = port->faults;
    for (int* fault : {&f.corrupt, &f.lose, &f.repeat, &f.swap, &f.shorten, &f.lengthen, &f.babble, &f.damage,
                       &f.stallIn, &f.stallOut, &f.corruptOut, &f.loseOut, &f.repeatOut})
      *fault = random.between(0, 1) < 0.1 ? static_cast<int>(random.between(1, 20)) : 0;
    f.frozen = random.between(0, 1) < 0.1;
    f.holdOut = random.between(0, 1) < 0.1;
    command.jointRates = random.vector<JointVector>(-100, 100);
    tick(static_cast<int>(random.between(1, 15)));
    if (trips() != kNoTrip) resetAtHost();
  }
  port->faults = {};
  command.jointRates.setConstant(0.1);
  tick(5);
  resetAtHost();
  EXPECT_TRUE(drives());
}

}  // namespace
}  // namespace haptiv::test
