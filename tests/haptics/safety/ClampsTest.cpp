#include "haptics/safety/Clamps.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/haptics/safety/MonitorPeriod.h"
#include "tests/haptics/tick/HapticTickFixture.h"

namespace haptiv {
namespace {

using testing::HapticTickTest;
using testing::kMonitorPeriod;
using testing::readingOf;

class ClampsTest : public ::testing::Test {
 protected:
  DeviceDescription description = loadDeviceDescription("vishard10");
  Clamps clamp{description, kMonitorPeriod};
  Jacobian J = ArmKinematics(description).evaluate(description.homeAngles).J_BT;
  const double sentSpeed = Clamps::kSentShare * description.safety.speedClamp;
  std::uint32_t clamps = kNoClamp;
};

TEST_F(ClampsTest, LeaveAloneWhatIsAllowed) {
  const Vector3 force(100, -50, 30), velocity(0.5, 0.2, 0);
  EXPECT_EQ(clamp.force(force, clamps), force);
  EXPECT_EQ(clamp.torque({1, 2, 3}, clamps), Vector3(1, 2, 3));
  EXPECT_EQ(clamp.velocity(velocity, velocity, 1, clamps), velocity);
  DeviceCommand command;
  command.jointRates.setConstant(0.2);
  command.jointTorques = -description.drives.torqueLimit;
  clamp.command(command, J, clamps);
  EXPECT_EQ(command.jointRates, JointVector::Constant(0.2));
  EXPECT_EQ(clamps, kNoClamp);
}

TEST_F(ClampsTest, ShortenWithoutTurning) {
  const Vector3 direction = Vector3(1, 2, -2) / 3;
  EXPECT_LT((clamp.force(900 * direction, clamps) - 170 * direction).norm(), 1e-9);
  EXPECT_EQ(clamps, kClampForce);
  EXPECT_LT((clamp.torque(90 * direction, clamps) - 13 * direction).norm(), 1e-9);
  EXPECT_LT((clamp.velocity(1.5 * direction, 9 * direction, 1, clamps) - sentSpeed * direction).norm(), 1e-9);
  EXPECT_EQ(clamps, kClampForce | kClampTorque | kClampSpeed | kClampAcceleration);
}

TEST_F(ClampsTest, HoldTheToolsSpeedAtTheDeviceWhateverTheScale) {
  const Vector3 fast(100, 0, 0);
  EXPECT_NEAR(clamp.velocity(fast, fast, 4, clamps).norm(), 4 * sentSpeed, 1e-9);
}

TEST_F(ClampsTest, LetTheToolBecomeFasterSlowlyAndSlowerAtOnce) {
  const double gain = description.safety.accelerationClamp * kMonitorPeriod;
  EXPECT_NEAR(clamp.velocity({0.5, 0, 0}, {1, 0, 0}, 1, clamps).x(), 0.5 + gain, 1e-9);
  EXPECT_EQ(clamps, kClampAcceleration);
  clamps = kNoClamp;
  EXPECT_EQ(clamp.velocity({1, 0, 0}, {-0.9, 0, 0}, 1, clamps).x(), -0.9);
  EXPECT_EQ(clamps, kNoClamp);
}

TEST_F(ClampsTest, NeverMakeAStepOfTheirOwn) {
  Vector3 force = clamp.force({0, 3, 0}, clamps), velocity = clamp.velocity({1, 0, 0}, {0, 1.3, 0}, 1, clamps);
  for (double x = 0; x < 1000; x += 0.5) {
    const Vector3 now = clamp.force({x, 3, 0}, clamps), v = clamp.velocity({1, 0, 0}, {x / 100, 1.3, 0}, 1, clamps);
    EXPECT_LE((now - force).norm(), 0.5 + 1e-9);
    EXPECT_LE((v - velocity).norm(), 0.005 + 1e-9);
    force = now;
    velocity = v;
  }
}

TEST_F(ClampsTest, KeepSetPointsWithinTheDrives) {
  DeviceCommand command;
  command.jointRates.setConstant(100);
  command.jointTorques.setConstant(-1000);
  clamp.command(command, Jacobian::Zero(), clamps);
  EXPECT_EQ(command.jointRates, description.drives.rateLimit);
  EXPECT_EQ(command.jointTorques, JointVector(-description.drives.torqueLimit));
  EXPECT_EQ(clamps, kClampJointRate | kClampJointTorque);
}

TEST_F(ClampsTest, KeepTheToolsSpeedWhateverTheControllerAddsToIt) {
  DeviceCommand command;
  for (int i = 0; i < kJointCount; ++i) command.jointRates[i] = i % 2 == 0 ? 6 : -3;
  const DeviceCommand wanted = command;
  ASSERT_GT((J.topRows<3>() * command.jointRates).norm(), 1.2 * sentSpeed);
  clamp.command(command, J, clamps);
  EXPECT_NEAR((J.topRows<3>() * command.jointRates).norm(), sentSpeed, 1e-9);
  EXPECT_LT((command.jointRates.normalized() - wanted.jointRates.normalized()).norm(), 1e-12);
  EXPECT_EQ(clamps, kClampCorrection);
}

TEST_F(ClampsTest, LetPassWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(clamp.force({nan, 0, 0}, clamps).allFinite());
  EXPECT_FALSE(clamp.velocity(Vector3::Zero(), {infinite, 0, 0}, 1, clamps).allFinite());
  DeviceCommand command;
  command.jointRates[4] = nan;
  clamp.command(command, J, clamps);
  EXPECT_FALSE(command.jointRates.allFinite());
}

TEST_F(HapticTickTest, HoldsTheScenesForceAtItsClampAndSaysSo) {
  scene.walls[0].shape.centre.x() -= 0.02;
  scene.walls[0].surface.stiffness = 1e6;
  computeBounds(scene);
  TickState state = ready();
  bool held = false;
  for (int i = 0; i < 300; ++i) {
    const TickRecord record = tick(scene, readingOf(description, start), state);
    EXPECT_LE(record.environmentForce.norm(), description.safety.forceClamp + 1e-9);
    held = held || (record.clamps & kClampForce) != 0;
  }
  EXPECT_TRUE(held);
}

}  // namespace
}  // namespace haptiv
