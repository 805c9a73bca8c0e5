#include "device/calibration/SensorBias.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "device/calibration/QuietCheck.h"
#include "tests/device/calibration/CalibrationBench.h"

namespace haptiv {
namespace {

using testing::HasSubstr;

std::string whyRefused(const Samples& first, const Samples& second, const DeviceDescription& description) {
  try {
    findBias(first, second, description);
  } catch (const CalibrationRefused& refused) {
    return refused.what();
  }
  return "it was not refused";
}

TEST(SensorBias, OfAMiscalibratedSensorIsFound) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    test::CalibrationBench bench(seed);
    const Samples first = bench.sampled(1000), second = bench.sampled(1000);
    const SensorBias found = findBias(first, second, bench.known);
    // Five standard deviations of the mean of 2000 samples.
    const Vector6 chance = 5 / std::sqrt(2000.) * found.deviation;
    EXPECT_TRUE(((found.bias - bench.built.sensor.bias).cwiseAbs().array() <= chance.array()).all())
        << found.bias.transpose() << " for " << bench.built.sensor.bias.transpose();
    EXPECT_GT(bench.built.sensor.bias.head<3>().norm(), 1) << "there was something to find";
  }
}

TEST(SensorBias, ThatIsTakenOutLeavesNoForceOfAnUntouchedHandle) {
  test::CalibrationBench bench;
  DeviceDescription calibrated = bench.known;
  const Samples first = bench.sampled(500), second = bench.sampled(500);
  calibrated.sensor.bias = findBias(first, second, bench.known).bias;
  const DeviceReading reading = bench.device.read();
  EXPECT_GT(bench.known.handleWrench(reading).force.norm(), 1);
  EXPECT_LT(calibrated.handleWrench(reading).force.norm(), 0.2);
}

TEST(SensorBias, IsRefusedWhileAHandTouchesTheHandle) {
  test::CalibrationBench bench;
  const Samples first = bench.sampled(500);
  bench.hand->hang(0.5 * Vector6::Unit(2));
  EXPECT_THAT(whyRefused(first, bench.sampled(500), bench.known), HasSubstr("force z drifted"));
}

TEST(SensorBias, IsRefusedWhileTheHandleSwings) {
  test::CalibrationBench bench;
  Samples first, second;
  for (int i = 0; i < 1000; ++i) {
    bench.hand->hang(0.05 * std::sin(0.1 * i) * Vector6::Unit(3));
    bench.device.write({});
    (i % 2 == 0 ? first : second).take(bench.device.read());
  }
  EXPECT_THAT(whyRefused(first, second, bench.known), HasSubstr("torque x scatters"));
}

TEST(SensorBias, IsRefusedWhileTheArmMoves) {
  test::CalibrationBench bench;
  const Samples quiet = bench.sampled(500);
  Samples moved;
  DeviceReading reading = bench.device.read();
  for (int i = 0; i < 500; ++i) {
    bench.device.write({});
    reading.sensorCounts = bench.device.read().sensorCounts;
    reading.encoderCounts[6] += 2;
    moved.take(reading);
  }
  EXPECT_THAT(whyRefused(quiet, moved, bench.known), HasSubstr("joint 7 moved"));
}

TEST(SensorBias, IsRefusedOfADeadASaturatedAndAnAbsentSensor) {
  test::CalibrationBench bench;
  const Samples quiet = bench.sampled(300);
  bench.device.inject({.sensorDead = 1u << 1});
  EXPECT_THAT(whyRefused(bench.sampled(300), quiet, bench.known), HasSubstr("force y says the same"));
  bench.device.inject({.sensorSaturated = 1u << 5});
  EXPECT_THAT(whyRefused(bench.sampled(300), quiet, bench.known), HasSubstr("torque z is at the end"));
  bench.device.inject({.disconnected = true});
  EXPECT_THAT(whyRefused(quiet, bench.sampled(300), bench.known), HasSubstr("disconnected"));
}

TEST(SensorBias, WantsEnoughSamples) {
  test::CalibrationBench bench;
  EXPECT_THAT(whyRefused(bench.sampled(300), bench.sampled(20), bench.known), HasSubstr("20 samples"));
  EXPECT_THAT(whyRefused({}, {}, bench.known), HasSubstr("0 samples"));
}

TEST(SensorBias, BeyondHalfTheRangeIsNone) {
  test::CalibrationBench bench;
  bench.hang((Vector6() << 0, 260, 0, 0, 0, 0).finished());
  Samples first, second;
  for (int i = 0; i < 600; ++i) {  // an arm that is held, however much hangs on it
    bench.device.write({});
    DeviceReading reading = bench.device.read();
    reading.encoderCounts = {};
    (i < 300 ? first : second).take(reading);
  }
  EXPECT_THAT(whyRefused(first, second, bench.known), HasSubstr("half of its range"));
}

TEST(Samples, HaveMeanAndDeviationOfTheirCounts) {
  Samples samples;
  for (const std::int16_t value : {-32768, 32767, -32768, 32767}) {
    DeviceReading reading;
    reading.sensorCounts[2] = value;
    reading.encoderCounts[4] = value > 0 ? 2147483647 : -2147483647 - 1;
    samples.take(reading);
  }
  EXPECT_EQ(samples.mean()[2], -0.5);
  EXPECT_EQ(samples.deviation()[2], 32767.5);
  EXPECT_EQ(samples.movement()[4], 4294967295.);
  EXPECT_EQ(Samples().mean(), Vector6(Vector6::Zero()));
}

}  // namespace
}  // namespace haptiv
