#include "device/calibration/ReferencePose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "device/calibration/CalibrationRefused.h"
#include "tests/device/calibration/CalibrationBench.h"

namespace haptiv {
namespace {

using testing::HasSubstr;

TEST(ReferencePose, TellsTheZeroOfMiscalibratedEncoders) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    test::CalibrationBench bench(seed);
    const FoundZero found = findZero(bench.sampled(300), bench.known, kPlausibleChange);
    // The arm stands in the pose to half a count, and sinks by a few counts under its weight.
    EXPECT_LT((found.zero - bench.built.encoders.zero).cwiseAbs().maxCoeff(), 20);
    EXPECT_GT(bench.built.encoders.zero.cwiseAbs().maxCoeff(), 1000) << "there was something to find";
    DeviceDescription homed = bench.known;
    homed.encoders.zero = found.zero;
    const JointVector off = homed.jointAngles(bench.device.read()) - bench.known.encoders.reference;
    EXPECT_LT(off.cwiseAbs().maxCoeff(), 1e-5);
  }
}

TEST(ReferencePose, ThatTheArmDoesNotStandInIsRefused) {
  test::CalibrationBench bench;
  bench.known.encoders.reference[2] += 0.5;
  EXPECT_THROW(findZero(bench.sampled(300), bench.known, kPlausibleChange), CalibrationRefused);
  try {
    findZero(bench.sampled(300), bench.known, kPlausibleChange);
  } catch (const CalibrationRefused& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("joint 3 stands at"));
  }
  EXPECT_NO_THROW(findZero(bench.sampled(300), bench.known, 100)) << "where no zero was known";
}

TEST(ReferencePose, IsNoneWhileTheArmMoves) {
  test::CalibrationBench bench;
  Samples samples;
  DeviceReading reading = bench.device.read();
  for (int i = 0; i < 300; ++i) {
    reading.encoderCounts[0] += 5;
    samples.take(reading);
  }
  EXPECT_THROW(findZero(samples, bench.known, kPlausibleChange), CalibrationRefused);
}

TEST(ReferencePose, ABoardIsToldItsCounts) {
  test::CalibrationBench bench;
  Homing* homing = bench.device.homing();
  ASSERT_NE(homing, nullptr);
  homing->home(bench.known.countsAt(bench.known.encoders.reference));
  EXPECT_TRUE(homing->homed());
  EXPECT_EQ(bench.device.read().encoderCounts, bench.known.countsAt(bench.known.encoders.reference));
}

TEST(SimulatedDevice, OfADescriptionWithZerosAndCrosstalkIsRightByIt) {
  const DeviceDescription built = miscalibrated(loadDeviceDescription("vishard10"), 9);
  SimulatedDevice device(built, built.homeAngles, nullptr, 1);
  device.start(1e-3);
  EXPECT_LT((built.jointAngles(device.read()) - built.homeAngles).cwiseAbs().maxCoeff(), 1e-5);
  EXPECT_EQ(device.read().encoderCounts, built.countsAt(built.homeAngles));
  device.write({});
  EXPECT_LT(built.handleWrench(device.read()).force.norm(), 0.25) << "noise alone";
}

}  // namespace
}  // namespace haptiv
