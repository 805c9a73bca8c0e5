#include "haptics/safety/EncoderMonitor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "device/described/DeviceDescription.h"
#include "haptics/safety/Faults.h"
#include "tests/haptics/safety/MonitorPeriod.h"

namespace haptiv {
namespace {

using testing::kMonitorPeriod;

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

}  // namespace
}  // namespace haptiv
