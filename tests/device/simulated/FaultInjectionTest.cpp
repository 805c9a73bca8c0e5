#include <gtest/gtest.h>

#include <memory>

#include "device/simulated/ScriptedHand.h"
#include "device/simulated/SimulatedDevice.h"

namespace haptiv {
namespace {

/// An arm that turns joint 3 at 1 rad/s, with a hand that pulls at it.
class FaultInjection : public testing::Test {
 protected:
  FaultInjection() {
    device_.start(1e-3);
    command_.enabled = true;
    command_.jointRates[2] = 1;
    run(100);
  }
  DeviceReading run(int ticks) {
    for (int i = 0; i < ticks; ++i) device_.write(command_);
    return device_.read();
  }
  DeviceReading runWith(const InjectedFaults& faults, int ticks = 20) {
    device_.inject(faults);
    return run(ticks);
  }

  DeviceDescription description_ = loadDeviceDescription("vishard10");
  SimulatedDevice device_{description_, description_.homeAngles,
                          std::make_unique<ScriptedHand>(std::vector<HandWaypoint>{{0, {0.4, 0.05, 0.05}}}), 1};
  DeviceCommand command_;
};

TEST_F(FaultInjection, WithoutAnyTheDeviceRunsOn) {
  const DeviceReading reading = runWith({});
  EXPECT_EQ(reading.trips, kNoTrip);
  EXPECT_TRUE(reading.connected);
  EXPECT_TRUE(device_.truth().driving);
}

TEST_F(FaultInjection, SensorSticksOrSaturatesOrIsDeadOnTheAxesThatAreNamedAndMendsAgain) {
  InjectedFaults faults;
  faults.sensorStuck = 1u << 0;
  faults.sensorSaturated = 1u << 1 | 1u << 5;
  faults.sensorDead = 1u << 2;
  const auto before = device_.read().sensorCounts;
  for (int i = 0; i < 20; ++i) {
    const auto counts = runWith(faults, 1).sensorCounts;
    EXPECT_EQ(counts[0], before[0]);
    EXPECT_EQ(counts[1], 20000);
    EXPECT_EQ(counts[2], 0);
    EXPECT_EQ(counts[5], 30000);
  }
  const auto mended = runWith({}).sensorCounts;
  EXPECT_NE(mended[0], before[0]);
  EXPECT_LT(mended[1], 20000);
  EXPECT_NE(mended[2], 0);
}

TEST_F(FaultInjection, EncoderSticksWhileItsJointTurnsOn) {
  InjectedFaults faults;
  faults.encoderStuck = 1u << 2;
  const std::int32_t before = device_.read().encoderCounts[2];
  const double angle = device_.truth().angles[2];
  EXPECT_EQ(runWith(faults).encoderCounts[2], before);
  EXPECT_GT(device_.truth().angles[2], angle + 0.015);
}

TEST_F(FaultInjection, EncoderThatJumpsOrBreaksIsSeenByTheBoardWhichBrakes) {
  InjectedFaults faults;
  faults.encoderJump[4] = 100'000;
  EXPECT_NE(runWith(faults, 1).trips & (kTripEncoder | kTripOverspeed), 0u);
  EXPECT_FALSE(device_.truth().driving);
  device_.start(1e-3);
  faults = {};
  faults.encoderBroken = 1u << 7;
  EXPECT_NE(runWith(faults, 1).trips & kTripEncoder, 0u);
}

TEST_F(FaultInjection, BrokenWireBetweenHostAndBoardKeepsTheLastReadingAndTheWatchdogBrakes) {
  InjectedFaults faults;
  faults.disconnected = true;
  const DeviceReading before = device_.read(), during = runWith(faults, 60);
  EXPECT_FALSE(during.connected);
  EXPECT_EQ(during.encoderCounts, before.encoderCounts);
  EXPECT_FALSE(device_.truth().driving);
  EXPECT_LT(device_.truth().rates[2], 0.2);
  const DeviceReading after = runWith({}, 1);
  EXPECT_TRUE(after.connected);
  EXPECT_NE(after.trips & kTripWatchdog, 0u);
}

TEST_F(FaultInjection, HostThatHangsIsBrakedByTheWatchdog) {
  InjectedFaults faults;
  faults.hostSilent = true;
  EXPECT_NE(runWith(faults, 60).trips & kTripWatchdog, 0u);
  EXPECT_TRUE(device_.read().connected);
  EXPECT_FALSE(device_.truth().driving);
}

TEST_F(FaultInjection, FrozenBoardSaysTheSameForEverAndTheArmStops) {
  InjectedFaults faults;
  faults.boardFrozen = true;
  const DeviceReading before = device_.read(), during = runWith(faults, 60);
  EXPECT_TRUE(during.connected);
  EXPECT_EQ(during.encoderCounts, before.encoderCounts);
  EXPECT_EQ(during.sensorCounts, before.sensorCounts) << "without noise: that is how a host can tell";
  EXPECT_LT(device_.truth().rates[2], 0.2);
}

TEST_F(FaultInjection, DeadMotorGivesNoTorqueAndItsJointRunsOutByItsFriction) {
  InjectedFaults faults;
  faults.motorDead = 1u << 2;
  runWith(faults, 1);
  EXPECT_EQ(device_.truth().torques[2], 0);
  run(1000);
  EXPECT_LT(device_.truth().rates[2], 0.2);
}

TEST_F(FaultInjection, EmergencyStopOfTheHandFileBrakesAtOnceAndTheOperatorResetsIt) {
  SimulatedDevice device(description_, description_.homeAngles,
                         std::make_unique<ScriptedHand>(
                             std::vector<HandWaypoint>{{0, {0.35, 0, 0}},
                                                       {0.1, {0.35, 0, 0}, kInputDeadMan | kInputEmergencyStop1},
                                                       {0.2, {0.35, 0, 0}, 0},
                                                       {0.3, {0.35, 0, 0}, kInputReset},
                                                       {0.4, {0.35, 0, 0}, kInputDeadMan}}),
                         1);
  device.start(1e-3);
  const auto until = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) device.write(command_);
    return device.read();
  };
  EXPECT_EQ(until(100).trips, kNoTrip);
  EXPECT_NE(until(1).trips & kTripEmergencyStop, 0u);
  EXPECT_FALSE(device.truth().driving);
  EXPECT_NE(until(150).trips & kTripEmergencyStop, 0u) << "it is latched";
  EXPECT_EQ(until(100).trips, kNoTrip);
  EXPECT_FALSE(device.truth().driving);
  EXPECT_EQ(until(100).inputs, kInputDeadMan);
  EXPECT_TRUE(device.truth().driving);
}

}  // namespace
}  // namespace haptiv
