#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <vector>

#include "device/control/ControlNames.h"
#include "haptics/servo/FastLoop.h"
#include "tests/haptics/control/RigidArm.h"

namespace haptiv {
namespace {

using testing::readingOf;
using testing::RigidArm;

constexpr double kServoRate = 1000;

/// A hand of a spring and a damper, whose target goes from home along x, and which may twist the handle.
struct Operator {
  Vector3 from = Vector3::Zero(), to = Vector3::Zero();  ///< in B [m]
  double stiffness = 400, damping = 40;                  ///< [N/m], [N s/m]
  Vector3 torque = Vector3::Zero();                      ///< in B [N m]

  Wrench operator()(double time, const Pose& X_BT, const Vector6& twist) const {
    const Vector3 target = from + std::min(1.0, time) * (to - from);  // in one second
    return {stiffness * (target - X_BT.position) - damping * twist.head<3>(), torque};
  }
};

class ControlModes : public ::testing::TestWithParam<ControlChoice> {
 protected:
  ControlModes() {
    description.sensor.forceNoise = description.sensor.torqueNoise = 0;  // as these readings are,
    description.drives.viscousFriction.setZero();                        // and this arm
    description.drives.coulombFriction.setZero();
    home = ArmKinematics(description).forward(description.homeAngles).position;
  }

  /// A wall whose face is so far from home, along x [m].
  HapticScene wallAt(double face) const {
    Wall wall;
    wall.shape.centre = home + Vector3(face + 0.1, 0, 0);
    wall.shape.axes = Vector3(0.1, 0.3, 0.3).asDiagonal();
    HapticScene scene;
    scene.walls = {wall};
    computeBounds(scene);
    return scene;
  }
  Operator reachingTo(const Vector3& offset) const {
    Operator hand;
    hand.from = home;
    hand.to = home + offset;
    return hand;
  }
  std::vector<TickRecord> run(HapticScene scene, const ControlChoice& choice, const Operator& hand, double seconds) {
    scene.control = choice;
    RigidArm arm(description, description.homeAngles, hand);
    std::vector<TickRecord> records;
    runFast(arm, description, kServoRate, scene, static_cast<std::uint64_t>(kServoRate * seconds), [&](const TickRecord& record) {
      records.push_back(record);
      return record.faults == kNoFault;
    });
    EXPECT_EQ(records.back().faults, kNoFault) << "at tick " << records.back().tick;
    return records;
  }
  /// How far the handle has turned from its first orientation [rad].
  double turnedBy(const TickRecord& first, const TickRecord& record) const {
    const ArmKinematics arm(description);
    const Matrix3 turn = arm.forward(record.jointAngles).rotation * arm.forward(first.jointAngles).rotation.transpose();
    return Eigen::AngleAxisd(turn).angle();
  }

  DeviceDescription description = loadDeviceDescription("vishard10");
  Vector3 home;
};

ControlChoice choiceOf(DisplayMode display, JointController joints, OrientationMode orientation) {
  return {display, joints, orientation, false};
}

std::vector<ControlChoice> allChoices() {
  std::vector<ControlChoice> choices;
  for (const DisplayMode display : kDisplayModes)
    for (const JointController joints : kJointControllers)
      for (const OrientationMode orientation : kOrientationModes)
        choices.push_back(choiceOf(display, joints, orientation));
  return choices;
}

std::string nameOf(const ::testing::TestParamInfo<ControlChoice>& info) {
  std::string name = haptiv::nameOf(info.param.display) + "_" + haptiv::nameOf(info.param.joints) + "_" +
                     haptiv::nameOf(info.param.orientation);
  std::erase(name, '-');
  return name;
}

INSTANTIATE_TEST_SUITE_P(EveryChoice, ControlModes, ::testing::ValuesIn(allChoices()), nameOf);

TEST_P(ControlModes, RestsInAWallWhereForceOverStiffnessSays) {
  // 20 N of the hand's spring: 10 mm deep in 2000 N/m; the ball's radius is 10 mm.
  const double rest = 0.05 - 0.01 + 0.01;
  const std::vector<TickRecord> records = run(wallAt(0.05), GetParam(), reachingTo({rest + 20.0 / 400, 0, 0}), 6);
  const double depth = records.back().position.x() - home.x() + 0.01 - 0.05;
  EXPECT_NEAR(depth, 0.010, 0.02 * 0.010);
  EXPECT_NEAR(records.back().penetration, 0.010, 0.02 * 0.010);
  EXPECT_NEAR(records.back().environmentForce.x(), -20, 0.02 * 20);
  EXPECT_LT((records.back().position - records[records.size() - 100].position).norm(), 1e-4) << "it does not rest";
}

TEST_P(ControlModes, KeepsTheOrientationOfAHandleThatNobodyTurns) {
  const std::vector<TickRecord> records = run({}, GetParam(), reachingTo({0.05, 0.1, -0.05}), 2);
  const bool isHeld = GetParam().orientation == OrientationMode::held;
  const bool isLed = GetParam().display != DisplayMode::impedance;
  if (!isHeld && !isLed) GTEST_SKIP() << "the arm's own inertia turns a handle that nothing holds";
  for (const TickRecord& record : records) EXPECT_LT(turnedBy(records.front(), record), isLed ? 5e-3 : 0.1);
}

TEST_P(ControlModes, CanBeRepeatedFromTheReadingsAlone) {
  Operator hand = reachingTo({0.1, 0.05, 0.02});
  hand.torque = {0.02, 0.01, -0.03};
  HapticScene scene = wallAt(0.05);
  const std::vector<TickRecord> recorded = run(scene, GetParam(), hand, 1);
  scene.control = GetParam();
  const HapticTick tick(description, 1 / kServoRate);
  TickState state;
  for (const TickRecord& before : recorded) {
    const TickRecord again = tick(scene, before.reading, state);
    ASSERT_EQ(again.command.mode, before.command.mode);
    ASSERT_EQ(again.command.jointRates, before.command.jointRates);
    ASSERT_EQ(again.command.jointTorques, before.command.jointTorques);
    ASSERT_EQ(again.desiredPosition, before.desiredPosition);
    ASSERT_EQ(again.environmentForce, before.environmentForce);
  }
}

TEST_P(ControlModes, TurnsAFreeHandleUnderATorqueAndLetsItStandWhereItIs) {
  Operator hand = reachingTo(Vector3::Zero());
  hand.torque = {0.05, -0.03, 0.04};
  const std::vector<TickRecord> records = run({}, GetParam(), hand, 1);
  const double turn = turnedBy(records.front(), records.back());
  if (GetParam().orientation == OrientationMode::held) {
    EXPECT_LT(turn, 0.01);
  } else if (GetParam().display != DisplayMode::impedance) {
    // I w' = tau - b w from rest: angle = tau/b (t - I/b (1 - exp(-b t/I))).
    const double time = static_cast<double>(records.size() - 2) / kServoRate;
    const double inertia = description.control.rotationalInertia, damping = description.control.rotationalDamping;
    const double angle =
        hand.torque.norm() / damping * (time - inertia / damping * -std::expm1(-damping * time / inertia));
    EXPECT_NEAR(turn, angle, 0.02 * angle);
  }
  for (const TickRecord& record : records) EXPECT_LT((record.position - home).norm(), 2e-3);
}

using ControlSchemes = ControlModes;

TEST_F(ControlSchemes, FeelTheSceneAtTheVirtualMassOrWhereTheArmIs) {
  HapticScene scene = wallAt(0.015);
  const HapticTick tick(description, 1 / kServoRate);
  const ArmKinematics arm(description);
  constexpr int kTicks = 40;  // no joint turns faster than it may
  const JointVector inside = arm.inverse(home + Vector3(0.008, 0, 0), description.homeAngles);
  for (const DisplayMode display : kDisplayModes) {
    scene.control = choiceOf(display, JointController::pd, OrientationMode::held);
    TickState state;
    DeviceReading reading = readingOf(description, description.homeAngles);
    reading.inputs = 0;
    tick(scene, reading, state);
    tick(scene, readingOf(description, description.homeAngles), state);
    // The arm is pushed 3 mm into the wall, joint angles within the limit of the tracking error; the ball is not.
    TickRecord record;
    for (int i = 1; i <= kTicks; ++i) {
      const JointVector q = description.homeAngles + (inside - description.homeAngles) * i / kTicks;
      record = tick(scene, readingOf(description, q), state);
    }
    ASSERT_EQ(record.faults, kNoFault);
    EXPECT_NEAR(record.penetration, display == DisplayMode::admittance ? 0 : 0.003, 1e-5) << haptiv::nameOf(display);
  }
}

TEST_F(ControlSchemes, ShowAStaticForceAsTheTorquesThatItsJacobianAndTheArmsWeightAskFor) {
  Zone zone;
  zone.kind = Zone::Kind::spring;
  zone.shape.centre = home;
  zone.shape.axes = Vector3(0.5, 0.5, 0.5).asDiagonal();
  zone.anchor = home + Vector3(0.05, -0.03, 0.04);
  HapticScene scene;
  scene.zones = {zone};
  scene.control = choiceOf(DisplayMode::impedance, JointController::pd, OrientationMode::held);
  computeBounds(scene);
  const HapticTick tick(description, 1 / kServoRate);
  TickState state;
  DeviceReading reading = readingOf(description, description.homeAngles);
  reading.inputs = 0;
  tick(scene, reading, state);
  reading.inputs = kInputDeadMan;
  TickRecord record;
  for (int i = 0; i < 2000; ++i) record = tick(scene, reading, state);  // all of the force has faded in
  ASSERT_EQ(record.command.mode, DriveMode::torque);
  const Vector3 force = zone.stiffness * (zone.anchor - record.position);
  const JointVector& q = record.jointAngles;
  const JointVector expected =
      ArmKinematics(description).jacobian(q).topRows<3>().transpose() * force + ArmDynamics(description).gravity(q);
  EXPECT_LT((record.command.jointTorques - expected).norm(), 1e-9);
  EXPECT_GT(expected.norm(), 5);
}

}  // namespace
}  // namespace haptiv
