#include "tests/device/DeviceContract.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace haptiv::test {

TEST_P(DeviceContract, StartsAtItsHome) {
  device_->start(kTick);
  const DeviceReading reading = device_->read();
  EXPECT_TRUE(reading.connected);
  const JointVector halfCount = 0.5000001 * description_.drives.countsPerRadian().cwiseInverse();
  const JointVector error = (description_.jointAngles(reading) - description_.homeAngles).cwiseAbs();
  EXPECT_TRUE((error.array() <= halfCount.array()).all()) << error.transpose();
}

TEST_P(DeviceContract, ReadingChangesNothing) {
  device_->start(kTick);
  const DeviceReading first = device_->read();
  for (int i = 0; i < 10; ++i) EXPECT_EQ(device_->read().encoderCounts, first.encoderCounts);
}

/// Motors that are bypassed are brakes without a ratchet: an arm sinks under its weight, slowly.
constexpr double kSinking = 0.25;  // [rad/s]

TEST_P(DeviceContract, IsBrakedWhenNotEnabledWhateverTheSetPoints) {
  if (!obeys()) GTEST_SKIP() << "it is a recording";
  for (const DriveMode mode : {DriveMode::rate, DriveMode::torque}) {
    device_->start(kTick);
    const JointVector before = description_.jointAngles(device_->read());
    DeviceCommand command;
    command.mode = mode;
    command.jointRates.setConstant(2);
    command.jointTorques.setConstant(20);
    const JointVector after = description_.jointAngles(run(command, 200));
    EXPECT_LT((after - before).cwiseAbs().maxCoeff(), kSinking * 0.2);
    EXPECT_EQ((after - before).head<5>(), (JointVector::Zero().head<5>())) << "they carry no weight";
    device_->stop();
  }
}

TEST_P(DeviceContract, StandsStillAtZeroRates) {
  if (!obeys()) GTEST_SKIP() << "it is a recording";
  device_->start(kTick);
  const DeviceReading before = device_->read();
  EXPECT_EQ(run(turning(0, 0), 200).encoderCounts, before.encoderCounts);
}

TEST_P(DeviceContract, TurnsEachJointTheWayAndAsFarAsCommandedAndNoOther) {
  if (!followsRates()) GTEST_SKIP() << "it does not follow rates";
  for (int joint = 0; joint < kJointCount; ++joint) {
    for (const double rate : {0.5, -0.5}) {
      device_->start(kTick);
      const JointVector before = description_.jointAngles(device_->read());
      const JointVector turned = description_.jointAngles(run(turning(joint, rate), 500)) - before;
      for (int i = 0; i < kJointCount; ++i) {
        // 0.5 rad/s for 0.5 s, less the start: at most 20 ms of it. The others feel the reaction.
        EXPECT_NEAR(turned[i], i == joint ? rate * 0.5 : 0, i == joint ? 0.01 : 0.003) << "joint " << i + 1;
      }
      device_->stop();
    }
  }
}

TEST_P(DeviceContract, BrakesOnceItIsDisabled) {
  if (!followsRates()) GTEST_SKIP() << "it does not follow rates";
  device_->start(kTick);
  run(turning(2, 1), 300);
  const DeviceReading braked = run(DeviceCommand{}, 300);
  const DeviceReading later = run(DeviceCommand{}, 100);
  EXPECT_EQ(later.encoderCounts[2], braked.encoderCounts[2]);
  const JointVector sunk = description_.jointAngles(later) - description_.jointAngles(braked);
  EXPECT_LT(sunk.cwiseAbs().maxCoeff(), kSinking * 0.1);
}

TEST_P(DeviceContract, TurnsEachJointTheWayOfItsTorque) {
  if (!obeys()) GTEST_SKIP() << "it is a recording";
  for (int joint = 0; joint < description_.jointCount(); ++joint) {
    device_->start(kTick);
    DeviceCommand command;
    command.mode = DriveMode::torque;
    command.enabled = true;
    command.jointTorques[joint] = 5 * description_.drives.coulombFriction[joint];
    const JointVector up = description_.jointAngles(run(command, 50));
    device_->stop();
    device_->start(kTick);
    command.jointTorques *= -1;
    const JointVector down = description_.jointAngles(run(command, 50));
    EXPECT_GT(up[joint], down[joint]) << "joint " << joint + 1;
    device_->stop();
  }
}

TEST_P(DeviceContract, NeverTurnsFasterThanItsLimits) {
  if (!followsRates()) GTEST_SKIP() << "it does not follow rates";
  device_->start(kTick);
  DeviceCommand command;
  command.enabled = true;
  command.jointRates.setConstant(50);
  JointVector before = description_.jointAngles(device_->read());
  const JointVector count = description_.drives.countsPerRadian().cwiseInverse();
  for (int i = 0; i < 300; ++i) {
    const JointVector now = description_.jointAngles(run(command, 1));
    // One count of rounding, and what all joints together push each other beyond, when all start at their limits.
    const JointVector most = 1.1 * description_.drives.rateLimit * kTick + count;
    ASSERT_TRUE(((now - before).array() <= most.array() * (1 + 1e-9)).all()) << "tick " << i;
    before = now;
  }
}

TEST_P(DeviceContract, StaysSaneWhenAskedForRatesThatAreNoNumbers) {
  device_->start(kTick);
  DeviceCommand command;
  command.enabled = true;
  command.jointRates.setConstant(std::numeric_limits<double>::quiet_NaN());
  command.jointRates[3] = std::numeric_limits<double>::infinity();
  const JointVector before = description_.jointAngles(device_->read());
  const JointVector after = description_.jointAngles(run(command, 100));
  EXPECT_LT((after - before).cwiseAbs().maxCoeff(), 0.7);  // no more than a tenth of a second at full rate
}

TEST_P(DeviceContract, FeelsNoHandWhereThereIsNone) {
  device_->start(kTick);
  for (int i = 0; i < 100; ++i) {
    const Wrench wrench = description_.handleWrench(run(turning(0, 0.2), 1));
    // Noise alone: six standard deviations and one count.
    EXPECT_LT(wrench.force.cwiseAbs().maxCoeff(),
              6 * description_.sensor.forceNoise + description_.sensor.forceResolution);
    EXPECT_LT(wrench.torque.cwiseAbs().maxCoeff(),
              6 * description_.sensor.torqueNoise + description_.sensor.torqueResolution);
  }
}

TEST_P(DeviceContract, StandsStillOnceStopped) {
  device_->start(kTick);
  run(moving(2), 50);
  device_->stop();
  const DeviceReading stopped = device_->read();
  EXPECT_EQ(run(moving(2), 50).encoderCounts, stopped.encoderCounts);
}

TEST_P(DeviceContract, StandsStillBeforeItIsStarted) {
  const DeviceReading before = device_->read();
  EXPECT_EQ(run(moving(2), 50).encoderCounts, before.encoderCounts);
}

TEST_P(DeviceContract, StopsTwiceAndStartsAgainAndMoves) {
  device_->start(kTick);
  run(moving(1), 50);
  device_->stop();
  device_->stop();
  device_->start(kTick);
  const DeviceReading before = device_->read();
  EXPECT_GT(run(moving(1), 50).encoderCounts[1], before.encoderCounts[1]);
}

TEST_P(DeviceContract, ReportsTheCountsThatItsEncodersAreTold) {
  device_->start(kTick);
  run(DeviceCommand{}, 5);
  Homing* homing = device_->homing();
  if (homing == nullptr) GTEST_SKIP() << "its encoders cannot be told";
  PoseCounts counts{};
  counts[3] = -12345;
  homing->home(counts);
  EXPECT_TRUE(homing->homed());
  EXPECT_NEAR(run(DeviceCommand{}, 1).encoderCounts[3], -12345, 1);
}

TEST_P(DeviceContract, KeepsItsCountsWhileTheDrivesAreOn) {
  device_->start(kTick);
  run(turning(0, 0.1), 20);
  Homing* homing = device_->homing();
  if (homing == nullptr) GTEST_SKIP() << "its encoders cannot be told";
  const DeviceReading before = device_->read();
  EXPECT_THROW(homing->home(PoseCounts{}), std::runtime_error);
  EXPECT_EQ(device_->read().encoderCounts, before.encoderCounts);
}

TEST_P(DeviceContract, RefusesAPeriodThatIsNone) {
  for (const double period : {0., -1e-3, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(device_->start(period), std::runtime_error);
  }
}

}  // namespace haptiv::test
