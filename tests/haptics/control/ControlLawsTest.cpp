#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "device/redundancy/matrices/PseudoInverse.h"
#include "haptics/control/ComputedTorque.h"
#include "haptics/control/ImpedanceDisplay.h"
#include "haptics/control/RotationalAdmittance.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

constexpr double kInertia = 0.02, kDamping = 0.1, kLawPeriod = 1e-3;

RotationState stepped(const RotationState& state, const Vector3& torque, double damping) {
  RotationState next;
  next.rate = nextRate(state, torque, kInertia, damping, kLawPeriod);
  next.rotation = turned(state.rotation, next.rate, kLawPeriod);
  return next;
}

TEST(RotationalAdmittance, GainsTheAngularMomentumThatTheHandGives) {
  test::Random random(1);
  RotationState state;
  Vector3 given = Vector3::Zero();
  for (int i = 0; i < 1000; ++i) {
    const Vector3 torque = random.vector<Vector3>(-1, 1);
    given += kLawPeriod * torque;
    state = stepped(state, torque, 0);
    EXPECT_LT((kInertia * state.rate - given).norm(), 1e-12);
  }
}

TEST(RotationalAdmittance, TurnsAtTorqueOverDampingInTheEnd) {
  const Vector3 torque(0.2, -0.1, 0.05);
  RotationState state;
  for (int i = 0; i < 5000; ++i) state = stepped(state, torque, kDamping);
  EXPECT_LT((state.rate - torque / kDamping).norm(), 1e-9);
}

TEST(RotationalAdmittance, ComesToRestUnderAnyDampingHoweverLarge) {
  RotationState state;
  state.rate = {3, -2, 1};
  const double energy = state.rate.squaredNorm();
  EXPECT_LT(stepped(state, Vector3::Zero(), 1e9).rate.squaredNorm(), 1e-9 * energy);
}

TEST(RotationalAdmittance, TurnsAboutOneAxisByTheAngleThatTheRateMakes) {
  test::Random random(2);
  for (int run = 0; run < 20; ++run) {
    const Vector3 rate = random.vector<Vector3>(-3, 3);
    const Eigen::AngleAxisd start(random.between(-3, 3), random.vector<Vector3>(-1, 1).normalized());
    Matrix3 rotation = start.toRotationMatrix();
    for (int i = 0; i < 700; ++i) rotation = turned(rotation, rate, kLawPeriod);
    const Eigen::AngleAxisd turn(0.7 * rate.norm(), rate.normalized());
    EXPECT_LT((rotation - (turn * start).toRotationMatrix()).norm(), 1e-11);
  }
}

TEST(RotationalAdmittance, StaysARotationInALongSession) {
  test::Random random(3);
  Matrix3 rotation = Matrix3::Identity();
  for (int i = 0; i < 200'000; ++i) rotation = turned(rotation, random.vector<Vector3>(-5, 5), kLawPeriod);
  EXPECT_LT((rotation * rotation.transpose() - Matrix3::Identity()).norm(), 1e-14);
  EXPECT_NEAR(rotation.determinant(), 1, 1e-14);
}

DeviceDescription withoutFriction() {
  DeviceDescription description = loadDeviceDescription("vishard10");
  description.drives.viscousFriction.setZero();
  description.drives.coulombFriction.setZero();
  return description;
}

TEST(ComputedTorque, MakesTheErrorADampedOscillatorInEveryPose) {
  const DeviceDescription description = withoutFriction();
  const ComputedTorque control(description);
  const ArmKinematics kinematics(description);
  const ArmDynamics arm(description);
  const double w = description.control.trackingFrequency, zeta = description.control.trackingDampingRatio;
  test::Random random(4);
  for (int run = 0; run < 100; ++run) {
    const JointMotion desired{random.vector<JointVector>(-3, 3), random.vector<JointVector>(-2, 2),
                              random.vector<JointVector>(-9, 9)};
    Measured measured;
    measured.angles = desired.angles + random.vector<JointVector>(-0.02, 0.02);
    measured.rates = desired.rates + random.vector<JointVector>(-0.1, 0.1);
    measured.arm = kinematics.evaluate(measured.angles);
    const Wrench hand{random.vector<Vector3>(-50, 50), random.vector<Vector3>(-2, 2)};
    const JointVector torques = control(desired, measured, hand);
    const JointVector error = desired.accelerations - arm.accelerations(measured.angles, measured.rates, torques, hand);
    const JointVector oscillator =
        -2 * zeta * w * (desired.rates - measured.rates) - w * w * (desired.angles - measured.angles);
    EXPECT_LT((error - oscillator).norm(), 1e-8 * (1 + oscillator.norm()));
  }
}

TEST(ComputedTorque, CarriesTheFrictionOfJointsThatSlideAndNoneOfJointsAtRest) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const ComputedTorque control(description), frictionless(withoutFriction());
  const ArmKinematics kinematics(description);
  Measured measured;
  measured.angles = description.homeAngles;
  measured.arm = kinematics.evaluate(measured.angles);
  JointMotion desired{measured.angles, JointVector::Zero(), JointVector::Zero()};
  EXPECT_EQ(control(desired, measured, {}), frictionless(desired, measured, {}));
  desired.rates = JointVector::Constant(-1);
  const JointVector friction = control(desired, measured, {}) - frictionless(desired, measured, {});
  EXPECT_LT((friction + description.drives.coulombFriction + description.drives.viscousFriction).norm(), 1e-9);
}

TEST(ComputedTorque, SaysWhatItNeedsOfADescriptionWithoutBodies) {
  DeviceDescription description = loadDeviceDescription("vishard10");
  description.bodies.links.clear();
  EXPECT_THROW(ComputedTorque{description}, std::runtime_error);
}

TEST(ImpedanceDisplay, BrakesSelfMotionAndNothingElse) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const ImpedanceDisplay display(description);
  const ArmKinematics arm(description);
  const ArmDynamics dynamics(description);
  test::Random random(5);
  for (int run = 0; run < 100; ++run) {
    Measured measured;
    measured.angles = description.homeAngles + random.vector<JointVector>(-0.3, 0.3);
    measured.arm = arm.evaluate(measured.angles);
    const PseudoInverse<6, kJointCount> inverse(measured.arm.J_BT, JointVector::Ones());
    const JointVector rates = random.vector<JointVector>(-1, 1);
    const JointVector selfMotion = inverse.nullSpacePart(rates);
    const JointVector weight = dynamics.gravity(measured.angles);
    measured.rates = selfMotion;
    const JointVector braking = display(measured, {}) - weight;
    EXPECT_LT(braking.dot(selfMotion), 0);
    EXPECT_LT((measured.arm.J_BT * braking).norm(), 1e-9);
    measured.rates = rates - selfMotion;  // moves the tool, and no more of the arm than that takes
    EXPECT_LT((display(measured, {}) - weight).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace haptiv
