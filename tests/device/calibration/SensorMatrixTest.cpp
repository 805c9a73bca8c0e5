#include "device/calibration/SensorMatrix.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>
#include <vector>

#include "device/calibration/CalibrationRefused.h"
#include "device/calibration/SensorBias.h"
#include "tests/device/calibration/CalibrationBench.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

using testing::HasSubstr;

/// Both ways along each axis.
std::vector<Vector6> loads(double force = 10, double torque = 0.4) {
  std::vector<Vector6> all;
  for (int axis = 0; axis < 6; ++axis) {
    const Vector6 load = (axis < 3 ? force : torque) * Vector6::Unit(axis);
    all.push_back(load);
    all.push_back(-load);
  }
  return all;
}

/// What a sensor without noise says.
std::vector<LoadCase> casesOf(const HandleSensor& sensor, const std::vector<Vector6>& loads) {
  std::vector<LoadCase> cases;
  for (const Vector6& load : loads) cases.push_back({load, sensor.matrix.fullPivLu().solve(load) + sensor.bias});
  return cases;
}

std::string whyRefused(const std::vector<LoadCase>& cases, const HandleSensor& sensor = {}) {
  try {
    findMatrix(cases, sensor.bias, sensor);
  } catch (const CalibrationRefused& refused) {
    return refused.what();
  }
  return "it was not refused";
}

TEST(SensorMatrix, OfExactReadingsIsFoundExactly) {
  const DeviceDescription known = loadDeviceDescription("vishard10");
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const HandleSensor built = miscalibrated(known, seed).sensor;
    const SensorMatrix found = findMatrix(casesOf(built, loads()), built.bias, known.sensor);
    EXPECT_TRUE(found.matrix.isApprox(built.matrix, 1e-12));
    EXPECT_LT(found.residual.maxCoeff(), 1e-12);
    EXPECT_LT(found.condition, 3);
  }
}

TEST(SensorMatrix, OfAMiscalibratedArmIsFoundFromWeightsAtItsHandle) {
  test::CalibrationBench bench(3);
  const Samples first = bench.sampled(500), second = bench.sampled(500);
  const Vector6 bias = findBias(first, second, bench.known).bias;
  std::vector<LoadCase> cases;
  for (const Vector6& load : loads()) {
    bench.hang(load);
    cases.push_back({load, bench.known.sensor.resolution().cwiseProduct(bench.sampled(1000).mean())});
  }
  const SensorMatrix found = findMatrix(cases, bias, bench.known.sensor);
  DeviceDescription calibrated = bench.known;
  calibrated.sensor.bias = bias;
  calibrated.sensor.matrix = found.matrix;
  // Noise of one sample over the root of 1000, five times, against a load of 10 N and 0.4 N m: half a per mille.
  const Vector6 pull = (Vector6() << 12, -9, 7, 0.3, -0.2, 0.1).finished();
  bench.hang(pull);
  const DeviceReading mean = bench.device.read();
  const Wrench felt = calibrated.handleWrench(mean), before = bench.known.handleWrench(mean);
  EXPECT_LT((felt.force - pull.head<3>()).norm(), 0.2);
  EXPECT_GT((before.force - pull.head<3>()).norm(), 1);
  EXPECT_LT((calibrated.sensor.matrix - bench.built.sensor.matrix).diagonal().cwiseAbs().maxCoeff(), 2e-3);
}

TEST(SensorMatrix, IsRefusedWhereTheLoadsLeaveAnAxisOpen) {
  std::vector<Vector6> some = loads();
  some[8].setZero();  // torque y
  some[9].setZero();
  EXPECT_THAT(whyRefused(casesOf({}, some)), HasSubstr("add loads with more torque y"));
  some[8][4] = 1e-3;
  EXPECT_THAT(whyRefused(casesOf({}, some)), HasSubstr("torque y"));
}

TEST(SensorMatrix, IsRefusedWhereALoadIsNotAsItsLineSays) {
  std::vector<LoadCase> cases = casesOf({}, loads());
  cases[4].load[2] = 12;  // 10 N hung there
  EXPECT_THAT(whyRefused(cases), HasSubstr("force z is off by"));
}

TEST(SensorMatrix, IsRefusedOfTooFewLoadsAndOfNoNumbers) {
  std::vector<LoadCase> cases = casesOf({}, loads());
  EXPECT_THAT(whyRefused({cases.begin(), cases.begin() + 6}), HasSubstr("6 loads are too few"));
  cases[3].raw[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(whyRefused(cases), HasSubstr("no finite number"));
}

TEST(SensorMatrix, IsRefusedWhereItConfusesTheAxes) {
  std::vector<LoadCase> cases = casesOf({}, loads());
  for (LoadCase& each : cases) each.load[3] = 1e-9 * each.load[2];
  EXPECT_THAT(whyRefused(cases), HasSubstr("confuses the axes"));
}

TEST(SensorMatrix, HasAConditionThatKnowsSingularOnes) {
  HandleSensor sensor;
  EXPECT_NEAR(sensorMatrixCondition(sensor), 1, 1e-12);
  sensor.matrix(2, 2) = 0;
  EXPECT_GT(sensorMatrixCondition(sensor), 1e12);
}

}  // namespace
}  // namespace haptiv
