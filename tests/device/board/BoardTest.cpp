#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/device/board/BoardBench.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct BoardCommands : testing::Test, test::BoardBench {};

TEST_F(BoardCommands, DriveTheArmOnceTheDeadManIsPressed) {
  command.drive.enabled = true;
  command.drive.jointRates[2] = 0.5;
  tick(3);
  EXPECT_TRUE(board.demand().braked);
  press(kInputDeadMan);
  tick();
  EXPECT_FALSE(board.demand().braked);
  EXPECT_EQ(board.demand().setPoints, command.drive.jointRates);
  EXPECT_EQ(trips(), kNoTrip);
}

TEST_F(BoardCommands, AreTorquesInTheModeOfTorque) {
  command.drive.mode = DriveMode::torque;
  command.drive.jointTorques.setConstant(1.5);
  drive();
  EXPECT_EQ(board.demand().mode, DriveMode::torque);
  EXPECT_EQ(board.demand().setPoints, JointVector(JointVector::Constant(1.5)));
}

TEST_F(BoardCommands, BrakeTheArmAndLetItGoOnWithoutATrip) {
  drive();
  command.drive.enabled = false;
  tick();
  EXPECT_FALSE(drives());
  EXPECT_EQ(board.demand().setPoints, JointVector(JointVector::Zero()));
  command.drive.enabled = true;
  tick();
  EXPECT_TRUE(drives());
  EXPECT_EQ(trips(), kNoTrip);
}

TEST_F(BoardCommands, OfAnOldOrRepeatedFrameAreRefused) {
  drive(0.5);
  BoardCommand late = command;
  late.heartbeat -= 5;
  late.drive.jointRates.setConstant(2);
  for (const std::uint32_t back : {0u, 1u, 1000u}) {
    late.sequence = command.sequence - back;
    EXPECT_EQ(board.accept(late), Acceptance::outOfOrder);
  }
  EXPECT_EQ(board.demand().setPoints[0], 0.5);
  EXPECT_EQ(board.report().counters.outOfOrder, 3u);
}

TEST_F(BoardCommands, MayWrapTheirSequence) {
  command.sequence = 0xfffffff0u;
  command.heartbeat = 0xfffffff8u;
  drive();
  tick(40);
  EXPECT_EQ(last, Acceptance::accepted);
  EXPECT_TRUE(drives());
}

TEST_F(BoardCommands, OfAHostThatBeginsAnewAreAcceptedOnceTheWatchdogIsOut) {
  command.sequence = 50'000;
  command.heartbeat = 70'000;
  drive();
  hostLives = false;
  const DeviceCommand enabled = command.drive;
  command = {};
  command.drive = enabled;
  tick(9);
  EXPECT_EQ(send(), Acceptance::outOfOrder) << "the one before may yet live";
  tick(3);
  EXPECT_EQ(send(), Acceptance::accepted);
  EXPECT_EQ(board.report().lastSequence, command.sequence);
  hostLives = true;
  tick(5);
  EXPECT_EQ(last, Acceptance::accepted);
  EXPECT_FALSE(drives()) << "the trip is latched";
  rearm();
  EXPECT_TRUE(drives());
}

TEST_F(BoardCommands, ThatAreNoNumbersAreRefusedAndStopTheDrives) {
  for (const double wrong : {kNaN, std::numeric_limits<double>::infinity()}) {
    for (JointVector* values : {&command.drive.jointRates, &command.drive.jointTorques}) {
      drive();
      ASSERT_TRUE(drives());
      (*values)[7] = wrong;
      EXPECT_EQ(send(), Acceptance::notFinite);
      EXPECT_FALSE(drives());
      EXPECT_TRUE(trips() & kTripCommand);
      values->setZero();
      tick(12);
      rearm();
      release(kInputDeadMan);
      command.drive.enabled = false;
      tick();
    }
  }
}

TEST_F(BoardCommands, NeverMakeAnUnsafeSetPointWhateverTheyAsk) {
  test::Random random(1);
  const auto& limits = description.drives;
  drive();
  for (int i = 0; i < 20'000; ++i) {
    const double size = std::pow(10, random.between(-3, 250));
    command.drive.mode = i % 2 ? DriveMode::rate : DriveMode::torque;
    command.drive.jointRates = random.vector<JointVector>(-size, size);
    command.drive.jointTorques = random.vector<JointVector>(-size, size);
    if (i % 7 == 0) command.drive.jointRates[i % kJointCount] = kNaN;
    tick();
    const DriveDemand demand = board.demand();
    const JointVector& limit = demand.mode == DriveMode::rate ? limits.rateLimit : limits.torqueLimit;
    ASSERT_TRUE((demand.setPoints.cwiseAbs().array() <= limit.array()).all());  // and so no NaN
    if (i % 7 == 0) {
      ASSERT_FALSE(drives());
      command.drive.jointRates.setZero();
      rearm();
      ASSERT_TRUE(drives()) << "tick " << i;
    }
  }
  EXPECT_GT(board.report().counters.clamped, 10'000u);
}

TEST_F(BoardCommands, AreReportedWithTheirSequence) {
  drive();
  tick(5);
  EXPECT_EQ(board.report().lastSequence, command.sequence);
  EXPECT_EQ(board.report().counters.accepted, command.sequence);
  board.countDamaged();
  EXPECT_EQ(board.report().counters.damaged, 1u);
}

TEST_F(BoardCommands, AreNotNeededForTheBoardToReportItsWires) {
  hostLives = false;
  inputs.encoderCounts[4] = -77;
  inputs.sensorCounts[2] = 5;
  press(kInputEmergencyStop3);
  tick();
  const BoardReport report = board.report();
  EXPECT_EQ(report.reading.encoderCounts, inputs.encoderCounts);
  EXPECT_EQ(report.reading.sensorCounts, inputs.sensorCounts);
  EXPECT_EQ(report.reading.inputs, kInputEmergencyStop3);
  EXPECT_EQ(report.time, now);
}

TEST_F(BoardCommands, MaySetTheEncodersZeroWhileTheDrivesAreOff) {
  inputs.encoderCounts.fill(1234);
  tick();
  std::array<std::int32_t, kJointCount> zero{};
  zero[3] = -9;
  EXPECT_TRUE(board.home(zero));
  EXPECT_EQ(board.report().reading.encoderCounts, zero);
  tick(3);
  EXPECT_EQ(board.report().reading.encoderCounts, zero);
  drive();
  EXPECT_TRUE(drives()) << "the zero must not look like motion";
  EXPECT_FALSE(board.home({}));
  EXPECT_EQ(board.report().reading.encoderCounts, zero);
}

}  // namespace
}  // namespace haptiv
