#include "app/calibration/HungWeight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/calibration/Calibration.h"
#include "device/calibration/CalibrationRefused.h"

namespace haptiv {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const HandleSensor& sensor() {
  static const DeviceDescription description = loadDeviceDescription("vishard10");
  return description.sensor;
}

std::string refusal(const std::vector<Vector6>& loads) {
  try {
    expectTelling(loads, sensor());
  } catch (const CalibrationRefused& refused) {
    return refused.what();
  }
  return "they were not refused";
}

/// Weights of 1 kg, each way, at the tool and 4 cm beside it.
std::vector<Vector6> everyWay() {
  std::vector<Vector6> loads;
  for (int axis = 0; axis < 3; ++axis)
    for (const double way : {1.0, -1.0})
      for (const double beside : {0.0, 0.04})
        loads.push_back(loadOf({1, way * Vector3::Unit(axis), beside * Vector3::Unit((axis + 1) % 3)}));
  return loads;
}

TEST(HungWeight, PullsAndTurnsAboutTheTool) {
  const Vector6 load = loadOf({2, -Vector3::UnitZ(), Vector3(0.1, 0, 0)});
  const Vector6 expected = (Vector6() << 0, 0, -19.6133, 0, 1.96133, 0).finished();
  EXPECT_TRUE(load.isApprox(expected, 1e-12)) << load.transpose();
}

TEST(HungWeight, InEveryPoseAndAtALeverTellsAllAxes) {
  EXPECT_LT(expectTelling(everyWay(), sensor()), 10);
  EXPECT_LT(expectTelling(standardLoads(), sensor()), 10);
}

TEST(HungWeight, InOnePlaceAloneLeavesTorquesOpen) {
  std::vector<Vector6> loads;
  for (int i = 0; i < 8; ++i) loads.push_back(loadOf({0.5 + 0.1 * i, (i % 2 == 0 ? 1 : -1) * Vector3::Unit(i % 3)}));
  EXPECT_THAT(refusal(loads), AllOf(HasSubstr("badly apart"), HasSubstr("torque")));
}

TEST(HungWeight, TooFewOrTooHeavyOnesAreNamed) {
  std::vector<Vector6> loads = everyWay();
  EXPECT_THAT(refusal({loads.begin(), loads.begin() + 6}), HasSubstr("6 loads are too few"));
  loads[4] = loadOf({1000, Vector3::UnitX()});
  EXPECT_THAT(refusal(loads), AllOf(HasSubstr("load 5: its force x is beyond"), HasSubstr("make it less")));
  EXPECT_THAT(refusal({}), HasSubstr("too few"));
}

TEST(HungWeight, OfNoNumberIsRefused) {
  std::vector<Vector6> loads = everyWay();
  loads[2][3] = std::nan("");
  EXPECT_NE(refusal(loads), "they were not refused");
}

}  // namespace
}  // namespace haptiv
