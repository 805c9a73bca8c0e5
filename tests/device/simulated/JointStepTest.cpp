#include "device/simulated/plant/JointStep.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/Random.h"

namespace haptiv {
namespace {

constexpr double kDriveStep = 0.125e-3;
constexpr DriveSettings kStrong{.rate = 6, .torque = 1e6, .inertia = 1, .bandwidth = 400, .brakeDamping = 80};
constexpr DriveSettings kWeak{.rate = 6, .torque = 50, .inertia = 0.5, .bandwidth = 400, .brakeDamping = 80};

/// The first of ten joints; the others stand, and pull at nothing.
struct OneJoint {
  explicit OneJoint(const DriveSettings& settings, double dryFriction = 0)
      : drive(settings), inertia(settings.inertia) {
    step.mass.setIdentity();
    step.mass(0, 0) = inertia;
    step.rates = step.load = step.viscous = step.coulomb = JointVector::Zero();
    step.coulomb[0] = dryFriction;
    step.dt = kDriveStep;
  }
  void advance(const TorqueLaw& law, double load) {
    step.law[0] = law;
    step.load[0] = load;
    const double before = step.rates[0];
    step.rates = step.solve();
    torque = law.at(step.rates[0]);
    drive.moved(torque, (step.rates[0] - before) / kDriveStep, kDriveStep);
    angle += kDriveStep * step.rates[0];
  }
  double rate() const { return step.rates[0]; }

  JointDrive drive;
  double inertia;
  JointStep step;
  double angle = 0, torque = 0;
};

TEST(JointDrive, FollowsARateStepAsALowPassOfItsBandwidth) {
  OneJoint joint(kStrong);
  for (double t = kDriveStep; t < 0.05; t += kDriveStep) {
    joint.advance(joint.drive.rate(2, 0), 0);
    // The step of integration makes it slower by at most bandwidth dt / 2 times 1/e.
    EXPECT_NEAR(joint.rate(), 2 * (1 - std::exp(-400 * t)), 2 * 0.025 / std::numbers::e);
  }
}

TEST(JointDrive, NeverExceedsItsRateAndTorque) {
  test::Random random(1);
  OneJoint joint(kWeak);
  for (int i = 0; i < 20000; ++i) {
    const double before = joint.rate();
    joint.advance(joint.drive.rate(random.between(-40, 40), 0), 0);
    EXPECT_LE(std::abs(joint.rate()), kWeak.rate * 1.05);  // its memory of a load, after a torque that was cut off
    EXPECT_LE(std::abs(joint.torque), kWeak.torque);
    EXPECT_LE(std::abs(joint.rate() - before), 50 / 0.5 * kDriveStep + 1e-12);
  }
}

TEST(JointDrive, CarriesALoadWithinItsTorqueAndYieldsToMore) {
  OneJoint joint(kWeak);
  for (int i = 0; i < 2000; ++i) joint.advance(joint.drive.rate(0, 0), 30);
  // load / (I bandwidth observer), but for the steps of time
  EXPECT_NEAR(joint.angle, 30 / (0.5 * 400 * 800), 0.1 * 1.9e-4);
  EXPECT_NEAR(joint.torque, -30, 1e-9);
  EXPECT_NEAR(joint.rate(), 0, 1e-9);
  const double before = joint.angle;
  for (int i = 0; i < 2000; ++i) joint.advance(joint.drive.rate(0, 0), 60);
  // 10 N m too much for 0.25 s at 0.5 kg m^2: half a t squared, less what the motor held at first.
  EXPECT_NEAR(joint.angle - before, 0.5 * 20 * 0.25 * 0.25, 0.02 * 0.625);
}

TEST(JointDrive, StartsWithTheTorqueThatHoldsTheWeight) {
  OneJoint joint(kWeak);
  for (int i = 0; i < 100; ++i) joint.advance(joint.drive.rate(0, 30), -30);
  EXPECT_NEAR(joint.angle, 0, 1e-12);
}

TEST(JointDrive, GivesTheTorqueThatIsAskedForWithinItsLimit) {
  OneJoint joint(kWeak);
  joint.advance(joint.drive.torque(20), 0);
  EXPECT_NEAR(joint.rate(), 20 / 0.5 * kDriveStep, 1e-12);
  joint.advance(joint.drive.torque(-400), 0);
  EXPECT_EQ(joint.torque, -50);
}

TEST(JointDrive, BrakesFastWithinItsTorqueAndLetsALoadSinkSlowly) {
  OneJoint joint(kWeak);
  joint.step.rates[0] = 5;
  for (int i = 0; i < 800; ++i) {
    const double before = joint.rate();
    joint.advance(joint.drive.brake(), 0);
    EXPECT_LE(joint.rate(), before);
    EXPECT_GE(joint.rate(), 0);
    EXPECT_LE(std::abs(joint.torque), kWeak.torque);
  }
  EXPECT_LT(joint.rate(), 0.01);  // in 0.1 s
  for (int i = 0; i < 800; ++i) joint.advance(joint.drive.brake(), 8);
  EXPECT_NEAR(joint.rate(), 8. / 80, 1e-6);
}

TEST(JointStep, DryFrictionHoldsAJointQuiteStillAndCarriesTheRestOfAHeavierLoad) {
  OneJoint joint(kWeak, 3);
  for (const double load : {2.9, -2.9, 2.9}) {
    joint.advance(joint.drive.torque(0), load);
    EXPECT_EQ(joint.rate(), 0);
  }
  joint.advance(joint.drive.torque(0), -4);
  EXPECT_NEAR(joint.rate(), -1 / 0.5 * kDriveStep, 1e-12);
}

TEST(JointStep, DryFrictionStopsAJointOnceAndDoesNotChatter) {
  OneJoint joint(kWeak, 3);
  joint.step.rates[0] = 0.5;
  bool stopped = false;
  for (int i = 0; i < 2000; ++i) {
    joint.advance(joint.drive.torque(0), 0);
    EXPECT_GE(joint.rate(), 0);
    EXPECT_TRUE(!stopped || joint.rate() == 0);
    stopped = joint.rate() == 0;
  }
  EXPECT_TRUE(stopped);
}

/// What is left of the equation for each joint: the dry friction that it takes [N m].
JointVector frictionLeft(const JointStep& step, const JointVector& w) {
  JointVector friction = step.load - step.viscous.cwiseProduct(w) - step.mass * (w - step.rates) / step.dt;
  for (int i = 0; i < kJointCount; ++i) friction[i] += step.law[static_cast<std::size_t>(i)].at(w[i]);
  return friction;
}

TEST(JointStep, SolvesItsEquationForAnArmInAnyPoseWithMotorsOfAnyKind) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const ArmDynamics dynamics(description);
  test::Random random(2);
  int standing = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const auto q = random.vector<JointVector>(-3, 3);
    JointStep step{dynamics.massMatrix(q),
                   random.vector<JointVector>(-1, 1),
                   random.vector<JointVector>(-50, 50),
                   description.drives.viscousFriction,
                   3 * description.drives.coulombFriction,
                   {},
                   kDriveStep};
    for (int i = 0; i < kJointCount; ++i) {
      if (random.between(0, 1) < 0.5) step.rates[i] = 0;
      if (random.between(0, 1) < 0.5) step.load[i] = 0;
      const double slope = random.between(0, 1) < 0.3 ? 0 : random.between(0, 1000);
      step.law[static_cast<std::size_t>(i)] = {random.between(-60, 60), slope, random.between(0, 80)};
    }
    const JointVector w = step.solve(), friction = frictionLeft(step, w);
    for (int i = 0; i < kJointCount; ++i) {
      // Torques of some 10^4 N m, inertia times rate over the step, rounded.
      if (w[i] == 0)
        ASSERT_LE(std::abs(friction[i]), step.coulomb[i] + 1e-6) << "trial " << trial << ", joint " << i + 1;
      else
        ASSERT_NEAR(friction[i], std::copysign(step.coulomb[i], w[i]), 1e-6)
            << "trial " << trial << ", joint " << i + 1;
      standing += w[i] == 0;
    }
  }
  EXPECT_GT(standing, 100);
}

}  // namespace
}  // namespace haptiv
