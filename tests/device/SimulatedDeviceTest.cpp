#include "device/simulated/SimulatedDevice.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "device/dynamics/ArmDynamics.h"
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
  // Half a count of the sensor, the start rounded to encoder counts, and what the arm yields until its drives carry
  // the hand's force: some 1e-5 m, times 400 N/m.
  EXPECT_LT((R_BT * wrench.force - 400 * offset).cwiseAbs().maxCoeff(), std::sqrt(3.) * 0.01 + 0.02);
  EXPECT_LE(wrench.torque.cwiseAbs().maxCoeff(), description.sensor.torqueResolution);
}

TEST(SimulatedDevice, HoldsStillAgainstAHandWithinItsPeakForce) {
  const DeviceDescription description = quiet();
  for (const Vector3& pull : {Vector3(9, 0, 0), Vector3(0, 9, 0), Vector3(0, 0, -9)}) {
    SimulatedDevice device(description, description.homeAngles, handAt(kHome + pull), 1);
    device.start(1e-3);
    const JointVector before = description.jointAngles(device.read());
    for (int i = 0; i < 1000; ++i) device.write(atRest());
    EXPECT_NEAR(description.handleWrench(device.read()).force.norm(), 170, 0.04);
    const JointVector moved = description.jointAngles(device.read()) - before;
    EXPECT_LT((Vishard10(description.links).jacobian(before) * moved).norm(), 2e-3);  // until the drives carry it
    EXPECT_LT(device.truth().rates.cwiseAbs().maxCoeff(), 1e-4);
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
  // The steps of integration are the same: what differs is when the hand's target is looked at, up to 2 ms apart.
  for (const JointVector& end : ends) EXPECT_LT((end - ends.back()).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(SimulatedDevice, CarriesItsWeightAndTheHandsForceWithTheTorqueOfItsMotors) {
  const DeviceDescription description = quiet();
  const ArmDynamics dynamics(description);
  SimulatedDevice device(description, description.homeAngles, handAt(kHome + Vector3(0, 0, -0.1)), 1);
  device.start(1e-3);
  for (int i = 0; i < 2000; ++i) device.write(atRest());
  const SimulatedDevice::Truth truth = device.truth();
  const Jacobian J = Vishard10(description.links).jacobian(truth.angles);
  const JointVector wanted = dynamics.gravity(truth.angles) - J.topRows<3>().transpose() * truth.hand.force;
  EXPECT_NEAR(truth.hand.force.z(), -40, 0.5);
  // Dry friction carries up to its share of it.
  const JointVector missing = (truth.torques - wanted).cwiseAbs() - description.drives.coulombFriction;
  EXPECT_LT(missing.maxCoeff(), 0.01);
  EXPECT_GT(std::abs(wanted[6]), 10) << "joint 7 carries what lies beyond it, and the hand";
}

TEST(SimulatedDevice, SinksSlowlyWhenItsMotorsAreBypassedInAnyPose) {
  const DeviceDescription description = quiet();
  for (const double stretch : {0., 0.4, 0.8, 1.2, 1.57}) {
    JointVector start = description.homeAngles;
    start[6] += 2 * stretch;  // the lift, stretched to the side
    start[7] -= 2 * stretch;
    SimulatedDevice device(description, start, nullptr, 1);
    device.start(1e-3);
    double fastest = 0;
    for (int i = 0; i < 1000; ++i) {
      device.write({});
      fastest = std::max(fastest, device.truth().rates.cwiseAbs().maxCoeff());
    }
    EXPECT_LT(fastest, 0.3);  // rad/s: less than 0.13 m/s at the end of 0.424 m
    EXPECT_FALSE(device.truth().driving);
  }
}

TEST(SimulatedDevice, BrakesFromOneMetreASecondWithinAHandsBreadthAndWithinItsTorques) {
  const DeviceDescription description = quiet();
  SimulatedDevice device(description, description.homeAngles, nullptr, 1);
  device.start(1e-3);
  DeviceCommand turning = atRest();
  const Vishard10 arm(description.links);
  Vector6 aside = Vector6::Zero();
  aside[1] = 1.2;
  turning.jointRates = arm.jacobian(description.homeAngles).completeOrthogonalDecomposition().solve(aside);
  for (int i = 0; i < 200; ++i) device.write(turning);
  const Vector3 before = arm.forward(device.truth().angles).position;
  ASSERT_GT((arm.jacobian(device.truth().angles) * device.truth().rates).head<3>().norm(), 1);
  for (int i = 0; i < 300; ++i) {
    device.write({});
    EXPECT_TRUE((device.truth().torques.cwiseAbs().array() <= description.drives.torqueLimit.array()).all());
  }
  EXPECT_LT((arm.forward(device.truth().angles).position - before).norm(), 0.1);
  EXPECT_LT(device.truth().rates.head<5>().cwiseAbs().maxCoeff(), 0.01);
}

TEST(SimulatedDevice, StaysWhereItIsInTorqueModeWhereTheTorquesHoldItsWeight) {
  const DeviceDescription description = quiet();
  const ArmDynamics dynamics(description);
  SimulatedDevice device(description, description.homeAngles, nullptr, 1);
  device.start(1e-3);
  const auto before = device.read().encoderCounts;
  DeviceCommand command = atRest();
  command.mode = DriveMode::torque;
  command.jointTorques = dynamics.gravity(description.homeAngles);
  for (int i = 0; i < 500; ++i) device.write(command);
  EXPECT_EQ(device.read().encoderCounts, before);
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
