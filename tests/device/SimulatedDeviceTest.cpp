#include "device/simulated/SimulatedDevice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "device/kinematics/Vishard10.h"
#include "device/simulated/ScriptedHand.h"

namespace haptiv {
namespace {

const Vector3 kHome(0.35, 0, 0);

std::unique_ptr<HandSource> handAt(const Vector3& p_BH) {
  return std::make_unique<ScriptedHand>(std::vector<HandWaypoint>{{0, p_BH}});
}

DeviceDescription quiet() {
  DeviceDescription description = loadDeviceDescription("vishard10");
  description.sensor.forceNoise = description.sensor.torqueNoise = 0;
  return description;
}

DeviceCommand atRest() {
  DeviceCommand command;
  command.enabled = true;
  return command;
}

TEST(SimulatedDevice, MeasuresTheHandsSpringInTheFrameOfTheTool) {
  const DeviceDescription description = quiet();
  JointVector turned = description.homeAngles;
  turned[8] += 0.7;
  turned[9] += 0.4;
  const Matrix3 R_BT = Vishard10(description.links).forward(turned).rotation;
  const Vector3 offset(0.02, -0.03, 0.05);
  SimulatedDevice device(description, turned, handAt(kHome + offset), 1);
  device.start(1e-3);
  for (int i = 0; i < 1000; ++i) device.write(atRest());
  const Wrench wrench = description.handleWrench(device.read());
  // Half a count of the sensor, and the start rounded to encoder counts: about 1e-5 m, times 400 N/m.
  EXPECT_LT((R_BT * wrench.force - 400 * offset).cwiseAbs().maxCoeff(), std::sqrt(3.) * 0.01 + 0.006);
  EXPECT_EQ(wrench.torque, Vector3::Zero());
}

TEST(SimulatedDevice, HoldsStillAgainstAHandWithinItsPeakForce) {
  const DeviceDescription description = quiet();
  for (const Vector3& pull : {Vector3(9, 0, 0), Vector3(0, 9, 0), Vector3(0, 0, -9)}) {
    SimulatedDevice device(description, description.homeAngles, handAt(kHome + pull), 1);
    device.start(1e-3);
    const auto before = device.read().encoderCounts;
    for (int i = 0; i < 500; ++i) device.write(atRest());
    EXPECT_NEAR(description.handleWrench(device.read()).force.norm(), 170, 0.02);
    EXPECT_EQ(device.read().encoderCounts, before);
  }
}

std::vector<DeviceReading> session(SimulatedDevice& device, int ticks) {
  std::vector<DeviceReading> readings;
  DeviceCommand command = atRest();
  device.start(1e-3);
  for (int i = 0; i < ticks; ++i) {
    readings.push_back(device.read());
    command.jointRates.setConstant(0.3 * std::sin(0.01 * i));
    device.write(command);
  }
  device.stop();
  return readings;
}

bool same(const std::vector<DeviceReading>& a, const std::vector<DeviceReading>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const DeviceReading& x, const DeviceReading& y) {
    return x.encoderCounts == y.encoderCounts && x.sensorCounts == y.sensorCounts;
  });
}

TEST(SimulatedDevice, RepeatsEveryBitForASeedAndAfterARestart) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const JointVector& home = description.homeAngles;
  SimulatedDevice a(description, home, handAt({0.4, 0.1, 0.05}), 5);
  SimulatedDevice b(description, home, handAt({0.4, 0.1, 0.05}), 5);
  SimulatedDevice other(description, home, handAt({0.4, 0.1, 0.05}), 6);
  const auto first = session(a, 1000);
  EXPECT_TRUE(same(first, session(b, 1000)));
  EXPECT_TRUE(same(first, session(a, 1000)));
  EXPECT_FALSE(same(first, session(other, 1000)));
}

TEST(SimulatedDevice, MovesAlikeAtEveryServoRate) {
  const DeviceDescription description = quiet();
  DeviceCommand command = atRest();
  command.jointRates << 1, -1, 0.5, 0.3, -0.6, 0.4, -0.8, 0.2, 1, -1;
  std::vector<JointVector> ends;
  for (const int rate : {500, 1000, 2000, 4000, 8000}) {
    SimulatedDevice device(description, description.homeAngles, handAt({0.5, 0.2, 0.1}), 1);
    device.start(1. / rate);
    for (int i = 0; i < rate / 2; ++i) device.write(command);
    ends.push_back(description.jointAngles(device.read()));
  }
  // The steps of integration are 0.25 or 0.125 ms: the angles differ by the trapezium's error and a count.
  for (const JointVector& end : ends) EXPECT_LT((end - ends.back()).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(SimulatedDevice, StandsAtARoundCount) {
  const DeviceDescription description = quiet();
  const JointVector start = description.homeAngles + JointVector::Constant(1e-6);
  SimulatedDevice device(description, start, nullptr, 1);
  const JointVector exact = start.cwiseProduct(description.drives.countsPerRadian());
  for (int i = 0; i < kJointCount; ++i) EXPECT_EQ(device.read().encoderCounts[i], std::lround(exact[i]));
}

TEST(SimulatedDevice, RefusesAStartThatIsNoPose) {
  const DeviceDescription description = quiet();
  JointVector start = description.homeAngles;
  start[6] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(SimulatedDevice(description, start, nullptr, 1), std::runtime_error);
}

}  // namespace
}  // namespace haptiv
