#include "haptics/safety/Monitors.h"

#include <gtest/gtest.h>

#include "haptics/safety/Clamps.h"
#include "tests/haptics/safety/MonitorPeriod.h"

namespace haptiv {
namespace {

using testing::kMonitorPeriod;

TEST(ToolSpeedMonitorTest, BrakesBeforeTheToolReachesItsClamp) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const ToolSpeedMonitor monitor(description);
  Measured measured;
  measured.arm = ArmKinematics(description).evaluate(description.homeAngles);
  const double perRate = measured.arm.J_BT.col(0).head<3>().norm();
  for (const double speed : {Clamps::kSentShare * description.safety.speedClamp, description.safety.speedClamp}) {
    measured.rates[0] = speed / perRate;
    EXPECT_EQ(monitor(measured), speed < description.safety.speedClamp ? kNoFault : kFaultToolSpeed);
  }
}

TEST(MissedTickBudgetTest, BearsABurstAndASteadyTrickleOfHalfTheTicks) {
  const MissedTickBudget budget(0.5, kMonitorPeriod);
  MissedTickState state;
  EXPECT_EQ(budget(450, state), kNoFault);
  EXPECT_EQ(budget(600, state), kFaultMissedTicks);
  state = {};
  std::uint32_t faults = kNoFault, missed = 0;
  for (int i = 0; i < 20'000; ++i) faults |= budget(missed += static_cast<std::uint32_t>(i % 2), state);
  EXPECT_EQ(faults, kNoFault);
  for (int i = 0; i < 20'000; ++i) faults |= budget(missed += 2, state);
  EXPECT_EQ(faults, kFaultMissedTicks);
}

TEST(FaultNames, TellEveryTripOfTheDevice) {
  for (std::uint32_t bit = 0; bit < 16; ++bit) {
    const std::uint32_t faults = faultsOfTrips(1u << bit);
    EXPECT_EQ(faultNames(faults).size(), 1u);
    EXPECT_NE(faultList(faults), "unknown fault");
  }
  EXPECT_EQ(tripNames(kTripWatchdog | kTripOverspeed | tripJoints(1u << 2)),
            (std::vector<std::string>{"watchdog", "joint too fast", "joint 3"}));
}

}  // namespace
}  // namespace haptiv
