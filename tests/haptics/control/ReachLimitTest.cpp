#include "haptics/control/ReachLimit.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "device/control/ResolutionNames.h"
#include "device/simulated/ScriptedHand.h"
#include "device/simulated/SimulatedDevice.h"
#include "haptics/control/InverseKinematics.h"
#include "haptics/servo/FastLoop.h"

namespace haptiv {
namespace {

/// The simulated arm, pulled by a hand of 170 N.
class BeyondReach : public ::testing::TestWithParam<std::tuple<ResolutionChoice, Vector3>> {
 protected:
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const ArmKinematics arm{description};
  const Vector3 home = arm.forward(description.homeAngles).position;

  /// The hand goes 2.5 m away in one and a half seconds, stays until 2.5 s, and is back at 4 s.
  std::vector<TickRecord> pull() const {
    const auto& [resolution, direction] = GetParam();
    const Vector3 away = home + 2.5 * direction.normalized();
    auto hand = std::make_unique<ScriptedHand>(
        std::vector<HandWaypoint>{{0, home}, {1.5, away}, {2.5, away}, {2.7, home + 0.4 * (away - home)}, {4, home}});
    SimulatedDevice device(description, description.homeAngles, std::move(hand), 1);
    HapticScene scene;
    scene.resolution = resolution;
    std::vector<TickRecord> records;
    runFast(device, description, 1000, scene, 4500, [&](const TickRecord& record) {
      records.push_back(record);
      return true;
    });
    return records;
  }
};

TEST_P(BeyondReach, StopsAtTheBorderWithoutAFaultAndComesBack) {
  const std::vector<TickRecord> records = pull();
  for (const TickRecord& record : records) {
    ASSERT_EQ(record.faults, kNoFault) << faultList(record.faults) << " at tick " << record.tick;
    const Vector3 led = arm.forward(record.desiredAngles).position;
    ASSERT_LT((record.desiredPosition - led).norm(), 1.5 * InverseKinematics::kLeash) << "at tick " << record.tick;
  }
  const Vector3 there = records[2400].position;
  EXPECT_LT((there - records[2300].position).norm(), 0.005) << "it does not rest at the border";
  EXPECT_GT((there - home).norm(), 0.35);
  EXPECT_LT((records.back().position - home).norm(), 0.03);
}

std::vector<std::tuple<ResolutionChoice, Vector3>> pulls() {
  std::vector<std::tuple<ResolutionChoice, Vector3>> all;
  for (const Strategy strategy : kStrategies) {
    for (const Vector3& direction : {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1), Vector3(1, 1, 1)})
      all.emplace_back(ResolutionChoice{strategy, Solution::full}, direction);
    all.emplace_back(ResolutionChoice{strategy, Solution::partitioned}, Vector3(0, 0, -1));
    all.emplace_back(ResolutionChoice{strategy, Solution::partitioned}, Vector3(-0.4, 1, 0));
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Vishard10, BeyondReach, ::testing::ValuesIn(pulls()));

TEST(ReachLimitTest, LeavesAloneWhatGoesInwardsOrAlongTheBorder) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  const ArmKinematics arm(description);
  const ReachLimit limit(description);
  const JointVector q = arm.inverse({0.97, 0, 0}, description.homeAngles);  // stretched; the border is at 1 m
  const ArmPose there = arm.evaluate(q);
  ASSERT_NEAR(there.X_BT.position.x(), 0.97, 1e-6);
  const Vector3 outwards = limit(q, there, {1, 0, 0});
  EXPECT_LT(outwards.x(), 0.5);
  EXPECT_GT(outwards.x(), 0);
  EXPECT_LT((limit(q, there, {-1, 0, 0}) - Vector3(-1, 0, 0)).norm(), 1e-9);
  EXPECT_LT((limit(q, there, {0, 0.3, 0}) - Vector3(0, 0.3, 0)).norm(), 0.01);
  const ArmPose home = arm.evaluate(description.homeAngles);
  for (const Vector3& velocity : {Vector3(1, 0, 0), Vector3(0, -1, 0), Vector3(0, 0, 1)})
    EXPECT_EQ(limit(description.homeAngles, home, velocity), velocity);
  EXPECT_EQ(limit(q, there, Vector3::Zero()), Vector3(Vector3::Zero()));
}

}  // namespace
}  // namespace haptiv
