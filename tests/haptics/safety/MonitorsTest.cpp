#include "haptics/safety/Monitors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "device/simulated/Noise.h"
#include "haptics/safety/Clamps.h"
#include "tests/haptics/tick/HapticTickFixture.h"

namespace haptiv {
namespace {

using testing::HapticTickTest;
using testing::readingOf;

constexpr double kMonitorPeriod = 1e-3;

class ClampsTest : public ::testing::Test {
 protected:
  DeviceDescription description = loadDeviceDescription("vishard10");
  Clamps clamp{description, kMonitorPeriod};
  Jacobian J = ArmKinematics(description).evaluate(description.homeAngles).J_BT;
  const double sentSpeed = Clamps::kSentShare * description.safety.speedClamp;
  std::uint32_t clamps = kNoClamp;
};

TEST_F(ClampsTest, LeaveAloneWhatIsAllowed) {
  const Vector3 force(100, -50, 30), velocity(0.5, 0.2, 0);
  EXPECT_EQ(clamp.force(force, clamps), force);
  EXPECT_EQ(clamp.torque({1, 2, 3}, clamps), Vector3(1, 2, 3));
  EXPECT_EQ(clamp.velocity(velocity, velocity, 1, clamps), velocity);
  DeviceCommand command;
  command.jointRates.setConstant(0.2);
  command.jointTorques = -description.drives.torqueLimit;
  clamp.command(command, J, clamps);
  EXPECT_EQ(command.jointRates, JointVector::Constant(0.2));
  EXPECT_EQ(clamps, kNoClamp);
}

TEST_F(ClampsTest, ShortenWithoutTurning) {
  const Vector3 direction = Vector3(1, 2, -2) / 3;
  EXPECT_LT((clamp.force(900 * direction, clamps) - 170 * direction).norm(), 1e-9);
  EXPECT_EQ(clamps, kClampForce);
  EXPECT_LT((clamp.torque(90 * direction, clamps) - 13 * direction).norm(), 1e-9);
  EXPECT_LT((clamp.velocity(1.5 * direction, 9 * direction, 1, clamps) - sentSpeed * direction).norm(), 1e-9);
  EXPECT_EQ(clamps, kClampForce | kClampTorque | kClampSpeed | kClampAcceleration);
}

TEST_F(ClampsTest, HoldTheToolsSpeedAtTheDeviceWhateverTheScale) {
  const Vector3 fast(100, 0, 0);
  EXPECT_NEAR(clamp.velocity(fast, fast, 4, clamps).norm(), 4 * sentSpeed, 1e-9);
}

TEST_F(ClampsTest, LetTheToolBecomeFasterSlowlyAndSlowerAtOnce) {
  const double gain = description.safety.accelerationClamp * kMonitorPeriod;
  EXPECT_NEAR(clamp.velocity({0.5, 0, 0}, {1, 0, 0}, 1, clamps).x(), 0.5 + gain, 1e-9);
  EXPECT_EQ(clamps, kClampAcceleration);
  clamps = kNoClamp;
  EXPECT_EQ(clamp.velocity({1, 0, 0}, {-0.9, 0, 0}, 1, clamps).x(), -0.9);
  EXPECT_EQ(clamps, kNoClamp);
}

TEST_F(ClampsTest, NeverMakeAStepOfTheirOwn) {
  Vector3 force = clamp.force({0, 3, 0}, clamps), velocity = clamp.velocity({1, 0, 0}, {0, 1.3, 0}, 1, clamps);
  for (double x = 0; x < 1000; x += 0.5) {
    const Vector3 now = clamp.force({x, 3, 0}, clamps), v = clamp.velocity({1, 0, 0}, {x / 100, 1.3, 0}, 1, clamps);
    EXPECT_LE((now - force).norm(), 0.5 + 1e-9);
    EXPECT_LE((v - velocity).norm(), 0.005 + 1e-9);
    force = now;
    velocity = v;
  }
}

TEST_F(ClampsTest, KeepSetPointsWithinTheDrives) {
  DeviceCommand command;
  command.jointRates.setConstant(100);
  command.jointTorques.setConstant(-1000);
  clamp.command(command, Jacobian::Zero(), clamps);
  EXPECT_EQ(command.jointRates, description.drives.rateLimit);
  EXPECT_EQ(command.jointTorques, JointVector(-description.drives.torqueLimit));
  EXPECT_EQ(clamps, kClampJointRate | kClampJointTorque);
}

TEST_F(ClampsTest, KeepTheToolsSpeedWhateverTheControllerAddsToIt) {
  DeviceCommand command;
  for (int i = 0; i < kJointCount; ++i) command.jointRates[i] = i % 2 == 0 ? 6 : -3;
  const DeviceCommand wanted = command;
  ASSERT_GT((J.topRows<3>() * command.jointRates).norm(), 1.2 * sentSpeed);
  clamp.command(command, J, clamps);
  EXPECT_NEAR((J.topRows<3>() * command.jointRates).norm(), sentSpeed, 1e-9);
  EXPECT_LT((command.jointRates.normalized() - wanted.jointRates.normalized()).norm(), 1e-12);
  EXPECT_EQ(clamps, kClampCorrection);
}

TEST_F(ClampsTest, LetPassWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(clamp.force({nan, 0, 0}, clamps).allFinite());
  EXPECT_FALSE(clamp.velocity(Vector3::Zero(), {infinite, 0, 0}, 1, clamps).allFinite());
  DeviceCommand command;
  command.jointRates[4] = nan;
  clamp.command(command, J, clamps);
  EXPECT_FALSE(command.jointRates.allFinite());
}

TEST_F(HapticTickTest, HoldsTheScenesForceAtItsClampAndSaysSo) {
  scene.walls[0].shape.centre.x() -= 0.02;
  scene.walls[0].surface.stiffness = 1e6;
  computeBounds(scene);
  TickState state = ready();
  bool held = false;
  for (int i = 0; i < 300; ++i) {
    const TickRecord record = tick(scene, readingOf(description, start), state);
    EXPECT_LE(record.environmentForce.norm(), description.safety.forceClamp + 1e-9);
    held = held || (record.clamps & kClampForce) != 0;
  }
  EXPECT_TRUE(held);
}

// --- sensor

class SensorMonitorTest : public ::testing::Test {
 protected:
  /// Faults of `ticks` ticks in which the force is the noise, but for an axis that is stuck.
  std::uint32_t watch(int ticks, int stuck) {
    const SensorMonitor monitor(description, kMonitorPeriod);
    SensorState state;
    Noise noise(3);
    std::uint32_t faults = kNoFault;
    for (int i = 0; i < ticks; ++i) {
      DeviceReading reading;
      for (int axis = 0; axis < 6; ++axis) {
        const double sigma = axis < 3 ? description.sensor.forceNoise / description.sensor.forceResolution
                                      : description.sensor.torqueNoise / description.sensor.torqueResolution;
        const double counts = axis == stuck ? 17 : sigma * noise.next();
        reading.sensorCounts[static_cast<std::size_t>(axis)] = static_cast<std::int16_t>(std::lround(counts));
      }
      faults |= monitor(reading, {}, state);
    }
    return faults;
  }
  DeviceDescription description = loadDeviceDescription("vishard10");
};

TEST_F(SensorMonitorTest, FindsAnAxisThatIsStuck) {
  for (int axis = 0; axis < 6; ++axis) {
    EXPECT_EQ(watch(50, axis), kNoFault);
    EXPECT_EQ(watch(150, axis), kFaultSensorStuck);
  }
}

TEST_F(SensorMonitorTest, IsNotAlarmedByAHealthySensorNorByOneWithoutNoise) {
  EXPECT_EQ(watch(200'000, -1), kNoFault);
  description.sensor.forceNoise = description.sensor.torqueNoise = 0;
  EXPECT_EQ(watch(200'000, -1), kNoFault);
}

TEST_F(SensorMonitorTest, FindsAForceThatNoHandHas) {
  const SensorMonitor monitor(description, kMonitorPeriod);
  SensorState state;
  Measured measured;
  measured.handForce = {0, 290, 0};
  EXPECT_EQ(monitor({}, measured, state), kNoFault);
  measured.handForce = {0, 290, 90};
  EXPECT_EQ(monitor({}, measured, state), kFaultHandForce);
}

// --- encoders

class EncoderMonitorTest : public ::testing::Test {
 protected:
  /// Faults of a joint that turns by so many counts a tick, at this rate.
  std::uint32_t turn(double countsPerTick, double rate, int ticks = 200) {
    const EncoderMonitor monitor(description, 1 / rate);
    EncoderState state;
    std::uint32_t faults = kNoFault;
    for (int i = 0; i < ticks; ++i) {
      DeviceReading reading;
      reading.encoderCounts[6] = static_cast<std::int32_t>(std::lround(-countsPerTick * i));
      faults |= monitor(reading, nullptr, state);
    }
    return faults;
  }
  DeviceDescription description = loadDeviceDescription("vishard10");
};

TEST_F(EncoderMonitorTest, CountsImpulsesAsTheDevicesCircuitDoes) {
  for (const double rate : {500., 1000., 4000., 8000.}) {
    EXPECT_EQ(turn(0.98 * 720e3 / rate, rate), kNoFault) << rate;
    EXPECT_EQ(turn(1.05 * 720e3 / rate, rate), kFaultJointSpeed) << rate;
  }
}

TEST_F(EncoderMonitorTest, TellsAJumpFromAJointThatIsTooFast) {
  for (const double rate : {500., 1000., 8000.}) {
    EXPECT_EQ(turn(4 * 720e3 / rate, rate, 2), kFaultEncoderJump) << rate;
  }
}

TEST_F(EncoderMonitorTest, FindsAnEncoderThatStandsStillWhileItsJointIsSentOn) {
  const EncoderMonitor monitor(description, kMonitorPeriod);
  for (const bool follows : {true, false}) {
    EncoderState state;
    JointVector desired = JointVector::Zero();
    std::uint32_t faults = kNoFault;
    for (int i = 0; i < 500; ++i) {
      DeviceReading reading;
      desired[2] += 1e-4;
      if (follows) reading.encoderCounts[2] = i;
      faults |= monitor(reading, &desired, state);
    }
    EXPECT_EQ(faults, follows ? kNoFault : kFaultEncoderStuck);
  }
}

TEST_F(EncoderMonitorTest, BearsAReadingThatComesTwice) {
  for (const double rate : {500., 1000., 8000.}) {
    const EncoderMonitor monitor(description, 1 / rate);
    EncoderState state;
    JointVector desired = JointVector::Zero();
    std::uint32_t faults = kNoFault;
    for (int i = 0; i < 1000; ++i) {
      DeviceReading reading;
      desired[2] += 4 / rate;
      reading.encoderCounts[2] = static_cast<std::int32_t>(i / 2 * 2 * 261e3 / rate);  // 4 rad/s
      faults |= monitor(reading, &desired, state);
    }
    EXPECT_EQ(faults, kNoFault) << rate;
  }
}

TEST_F(EncoderMonitorTest, TakesTheDevicesTimeWhereReadingsDidNotCome) {
  const EncoderMonitor monitor(description, kMonitorPeriod);
  for (const double part : {0.97, 1.05}) {  // of the impulses at which a joint is too fast
    EncoderState state;
    std::uint32_t faults = kNoFault;
    for (const int time : {1000, 2000, 3000, 8000, 9000, 9875, 11000, 11125}) {
      DeviceReading reading;
      reading.deviceTime = time;
      reading.encoderCounts[1] = static_cast<std::int32_t>(part * 0.72 * time);
      faults |= monitor(reading, nullptr, state);
    }
    EXPECT_EQ(faults, part < 1 ? kNoFault : kFaultJointSpeed);
  }
}

TEST_F(EncoderMonitorTest, DoesNotTakeTheSameReadingAgainForAnEncoderThatStands) {
  const EncoderMonitor monitor(description, kMonitorPeriod);
  for (const bool same : {true, false}) {
    EncoderState state;
    JointVector desired = JointVector::Zero();
    std::uint32_t faults = kNoFault;
    for (int i = 0; i < 9; ++i) {
      DeviceReading reading;
      reading.deviceTime = same ? 5000 : 5000 + 1000 * i;
      desired[2] += 1e-3;
      faults |= monitor(reading, &desired, state);
    }
    EXPECT_EQ(faults, same ? kNoFault : kFaultEncoderStuck);
  }
}

TEST_F(EncoderMonitorTest, BeginsWithTheFirstReadingThatIsConnected) {
  const EncoderMonitor monitor(description, kMonitorPeriod);
  EncoderState state;
  DeviceReading reading;
  for (int times = 0; times < 2; ++times) {  // at first, and after the device has left and come back elsewhere
    reading.connected = false;
    for (int i = 0; i < 5; ++i) EXPECT_EQ(monitor(reading, nullptr, state), kNoFault);
    reading.connected = true;
    reading.encoderCounts.fill(50'000 + 70'000 * times);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(monitor(reading, nullptr, state), kNoFault);
  }
  reading.encoderCounts[4] += 10'000;
  EXPECT_EQ(monitor(reading, nullptr, state), kFaultEncoderJump);
}

// --- the motion as a whole

TEST(ToolSpeedMonitorTest, BrakesBeforeTheToolReachesItsClamp) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const ToolSpeedMonitor monitor(description);
  Measured measured;
  measured.arm = ArmKinematics(description).evaluate(description.homeAngles);
  const double perRate = measured.arm.J_BT.col(0).head<3>().norm();
  for (const double speed : {Clamps::kSentShare * description.safety.speedClamp, description.safety.speedClamp}) {
    measured.rates[0] = speed / perRate;
    EXPECT_EQ(monitor(measured), speed < description.safety.speedClamp ? kNoFault : kFaultToolSpeed);
  }
}

TEST(MissedTickBudgetTest, BearsABurstAndASteadyTrickleOfHalfTheTicks) {
  const MissedTickBudget budget(0.5, kMonitorPeriod);
  MissedTickState state;
  EXPECT_EQ(budget(450, state), kNoFault);
  EXPECT_EQ(budget(600, state), kFaultMissedTicks);
  state = {};
  std::uint32_t faults = kNoFault, missed = 0;
  for (int i = 0; i < 20'000; ++i) faults |= budget(missed += static_cast<std::uint32_t>(i % 2), state);
  EXPECT_EQ(faults, kNoFault);
  for (int i = 0; i < 20'000; ++i) faults |= budget(missed += 2, state);
  EXPECT_EQ(faults, kFaultMissedTicks);
}

TEST(FaultNames, TellEveryTripOfTheDevice) {
  for (std::uint32_t bit = 0; bit < 16; ++bit) {
    const std::uint32_t faults = faultsOfTrips(1u << bit);
    EXPECT_EQ(faultNames(faults).size(), 1u);
    EXPECT_NE(faultList(faults), "unknown fault");
  }
  EXPECT_EQ(tripNames(kTripWatchdog | kTripOverspeed | tripJoints(1u << 2)),
            (std::vector<std::string>{"watchdog", "joint too fast", "joint 3"}));
}

}  // namespace
}  // namespace haptiv
