/// What the servo asks of the arm's kinematics and its redundancy resolution, singular postures included.
#include <gtest/gtest.h>

#include "device/kinematics/ArmKinematics.h"
#include "device/redundancy/DriftCorrection.h"
#include "device/redundancy/JointLimiter.h"
#include "device/redundancy/RedundancyResolution.h"
#include "tests/realtime/HiddenCalls.h"
#include "tests/realtime/ServoRun.h"

namespace haptiv {
namespace {

class ServoPathOfTheArm : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(BuiltIn, ServoPathOfTheArm, ::testing::Values("vishard10", "anthropomorphic7", "falcon"));

TEST_P(ServoPathOfTheArm, NeitherAllocatesNorLocks) {
  DeviceDescription description = loadDeviceDescription(GetParam());
  description.tool.position = Vector3(0.01, 0, -0.05);
  const ArmKinematics arm(description);
  SimulatedDevice device = testing::pulledArm(description);
  device.start(1e-3);
  const Pose desired = arm.forward(description.homeAngles);
  const RedundancyResolution resolution(description);
  DeviceCommand command;
  command.enabled = true;
  const testing::HiddenCalls calls = testing::hiddenCallsOf([&] {
    for (int i = 0; i < 100; ++i) {
      const DeviceReading reading = device.read();
      const JointVector q = description.jointAngles(reading);
      Vector6 twist = driftCorrection(desired, arm.evaluate(q).X_BT, description.control.driftGain);
      twist.head<3>() += 1e-3 * description.handleWrench(reading).force;
      const ResolutionChoice choice{kStrategies[i % 4], kSolutions[i / 4 % 2]};
      command.jointRates = resolution.rates(choice, q, arm.jacobian(q), twist, 1e-3);
      command.jointRates *= slowDownFactor(command.jointRates, description.drives.rateLimit);
      device.write(command);
      resolution.rates(choice, q, Jacobian::Zero(), twist, 1e-3);
      arm.inverse(desired.position, q);
      arm.skeleton(q);
    }
  });
  EXPECT_EQ(calls.heap, 0u);
  EXPECT_EQ(calls.locks, 0u);
}

}  // namespace
}  // namespace haptiv
