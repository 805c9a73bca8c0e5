#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "device/Encoder.h"
#include "device/simulated/ForceTorqueSensor.h"
#include "device/simulated/Noise.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

constexpr double kCountsPerRadian = 65189.9;

TEST(Encoder, IsNeverMoreThanHalfACountOff) {
  const Encoder encoder(kCountsPerRadian);
  test::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double angle = random.between(-100, 100);
    EXPECT_LE(std::abs(encoder.angle(encoder.count(angle)) - angle), 0.5000001 / kCountsPerRadian);
  }
}

TEST(Encoder, KeepsItsCountsAndItsZero) {
  const Encoder encoder(kCountsPerRadian);
  EXPECT_EQ(encoder.count(0), 0);
  for (const std::int32_t count : {1, -1, 123456, -2000000000, 2147483647}) {
    EXPECT_EQ(encoder.count(encoder.angle(count)), count);
  }
}

TEST(Encoder, StaysAtItsEndInsteadOfJumping) {
  const Encoder encoder(kCountsPerRadian);
  EXPECT_EQ(encoder.count(1e9), std::numeric_limits<std::int32_t>::max());
  EXPECT_EQ(encoder.count(-1e300), std::numeric_limits<std::int32_t>::min());
}

HandleSensor quietSensor() {
  HandleSensor sensor;
  sensor.forceNoise = sensor.torqueNoise = 0;
  return sensor;
}

/// After long enough for the low-pass.
std::array<std::int16_t, 6> measured(ForceTorqueSensor& sensor, const Wrench& wrench) {
  sensor.follow(wrench, 1);
  return sensor.measure();
}

TEST(ForceTorqueSensor, FollowsAWrenchAsALowPassOfItsBandwidth) {
  HandleSensor settings = quietSensor();
  settings.bandwidth = 1000;
  ForceTorqueSensor sensor(settings, 0);
  for (int i = 1; i <= 8; ++i) {
    sensor.follow({Vector3(100, 0, 0), Vector3(0, 0, -10)}, 0.25e-3);
    const auto counts = sensor.measure();
    const double part = 1 - std::exp(-0.25 * i);
    EXPECT_NEAR(counts[0] * settings.forceResolution, 100 * part, 0.010001);
    EXPECT_NEAR(counts[5] * settings.torqueResolution, -10 * part, 0.00050001);
  }
}

TEST(ForceTorqueSensor, RoundsToItsResolution) {
  const HandleSensor settings = quietSensor();
  ForceTorqueSensor sensor(settings, 0);
  test::Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Wrench wrench{random.vector<Vector3>(-400, 400), random.vector<Vector3>(-30, 30)};
    const auto counts = measured(sensor, wrench);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(std::abs(counts[axis] * settings.forceResolution - wrench.force[axis]), 0.010000001);
      EXPECT_LE(std::abs(counts[3 + axis] * settings.torqueResolution - wrench.torque[axis]), 0.00050001);
    }
  }
}

TEST(ForceTorqueSensor, SaturatesAtItsRange) {
  ForceTorqueSensor sensor(quietSensor(), 0);
  const auto counts = measured(sensor, {Vector3(1e9, -1e9, 400.5), Vector3(-31, 1e300, 0)});
  EXPECT_EQ(counts, (std::array<std::int16_t, 6>{20000, -20000, 20000, -30000, 30000, 0}));
}

TEST(ForceTorqueSensor, HasTheNoiseOfItsDescription) {
  HandleSensor settings;
  settings.forceResolution = 0.001;  // fine, so that rounding adds next to nothing
  settings.forceRange = 30;
  settings.forceNoise = 0.5;
  ForceTorqueSensor sensor(settings, 7);
  constexpr int kSamples = 20000;
  Vector3 sum = Vector3::Zero(), squares = Vector3::Zero();
  for (int i = 0; i < kSamples; ++i) {
    const auto counts = sensor.measure();
    const Vector3 force = 0.001 * Vector3(counts[0], counts[1], counts[2]);
    sum += force;
    squares += force.cwiseAbs2();
  }
  // Five standard deviations of the estimates: sigma / sqrt(n) and sigma / sqrt(2 n).
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(sum[axis] / kSamples, 0, 5 * 0.5 / std::sqrt(kSamples));
    EXPECT_NEAR(std::sqrt(squares[axis] / kSamples), 0.5, 5 * 0.5 / std::sqrt(2. * kSamples));
  }
}

TEST(Noise, HasTheTailsOfANormalDistribution) {
  Noise noise(3);
  constexpr int kSamples = 100000;
  int beyondOne = 0, beyondTwo = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double value = std::abs(noise.next());
    beyondOne += value > 1;
    beyondTwo += value > 2;
  }
  // 31.7 % and 4.55 %; the sum of twelve differs by less than 0.5 % of the samples.
  EXPECT_NEAR(beyondOne / double(kSamples), 0.3173, 0.01);
  EXPECT_NEAR(beyondTwo / double(kSamples), 0.0455, 0.005);
}

TEST(Noise, RepeatsItsBitsForASeedAndDiffersForAnother) {
  Noise a(11), b(11), other(12);
  int same = 0;
  for (int i = 0; i < 100; ++i) {
    const double value = a.next();
    EXPECT_EQ(value, b.next());
    same += value == other.next();
  }
  EXPECT_LT(same, 5);
}

}  // namespace
}  // namespace haptiv
