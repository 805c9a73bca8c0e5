/// The servo's path through the device never allocates: malloc is counted while it runs.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <vector>

#include "device/kinematics/ArmKinematics.h"
#include "device/redundancy/DriftCorrection.h"
#include "device/redundancy/JointLimiter.h"
#include "device/redundancy/RedundancyResolution.h"
#include "device/simulated/ScriptedHand.h"
#include "device/simulated/SimulatedDevice.h"

// Sanitizers bring their own malloc.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define HAPTIV_COUNTS_MALLOC 1

namespace {
thread_local bool counting = false;
thread_local int allocations = 0;
}  // namespace

extern "C" {
void* __libc_malloc(std::size_t size);

void* malloc(std::size_t size) {  // Eigen and operator new both end here
  if (counting) ++allocations;
  return __libc_malloc(size);
}
}
#endif

namespace haptiv {
namespace {

#ifdef HAPTIV_COUNTS_MALLOC

template <typename Function>
int allocationsOf(Function&& function) {
  allocations = 0;
  counting = true;
  function();
  counting = false;
  return allocations;
}

TEST(ServoPathOfTheDevice, CountsTheAllocationsThatThereAre) {
  EXPECT_EQ(allocationsOf([] { std::free(std::malloc(8)); }), 1);
  EXPECT_GE(allocationsOf([] { Eigen::MatrixXd::Random(20, 20).eval(); }), 1);
}

class ServoPathOfTheArm : public testing::TestWithParam<const char*> {};

TEST_P(ServoPathOfTheArm, NeverAllocates) {
  DeviceDescription description = loadDeviceDescription(GetParam());
  description.tool.position = Vector3(0.01, 0, -0.05);
  const ArmKinematics arm(description);
  SimulatedDevice device(description, description.homeAngles,
                         std::make_unique<ScriptedHand>(std::vector<HandWaypoint>{{0.01, {0.4, 0, 0}}}), 1);
  device.start(1e-3);
  const Pose desired = arm.forward(description.homeAngles);
  const RedundancyResolution resolution(description);
  DeviceCommand command;
  command.enabled = true;
  const int count = allocationsOf([&] {
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
  EXPECT_EQ(count, 0);
}
INSTANTIATE_TEST_SUITE_P(BuiltIn, ServoPathOfTheArm, testing::Values("vishard10", "anthropomorphic7"));

#endif

}  // namespace
}  // namespace haptiv
