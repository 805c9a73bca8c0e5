#include "haptics/servo/ServoLoop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

#include "tests/haptics/tick/ReadingOf.h"

namespace haptiv {
namespace {

using testing::IdealArm;

class ServoLoopTest : public ::testing::Test {
 protected:
  ServoLoopTest() { seams.scene.write(std::make_shared<const HapticScene>()); }

  void waitForTicks(std::uint64_t wanted) {
    while (seams.display.read().tick < wanted) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      seams.display.update();
    }
  }
  std::vector<TickRecord> drain() {
    std::vector<TickRecord> records;
    seams.log.drain([&](const TickRecord& record) { records.push_back(record); });
    return records;
  }

  DeviceDescription description = [] {
    DeviceDescription arm = loadDeviceDescription("vishard10");
    arm.sensor.forceNoise = arm.sensor.torqueNoise = 0;  // as an ideal arm's
    return arm;
  }();
  IdealArm arm{description, description.homeAngles, {1, 0, 0}};
  ServoSeams seams{1000};
};

TEST_F(ServoLoopTest, AccountsForEveryGridPointOfHalfASecond) {
  ServoLoop loop(arm, description, {1000}, seams);
  const Scheduling scheduling = loop.start();
  EXPECT_FALSE(scheduling.explanation.empty());
  waitForTicks(500);
  loop.stop();
  const std::vector<TickRecord> records = drain();
  ASSERT_FALSE(records.empty());
  EXPECT_EQ(seams.log.dropped(), 0u);
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(records[i].tick, i + records[i].missedTicks);
    EXPECT_GE(records[i].time, static_cast<std::int64_t>(records[i].tick) * 1'000'000);  // never before its time
    EXPECT_GE(records[i].wakeLateness, 0);
    EXPECT_GE(records[i].computeTime, 0);
    EXPECT_EQ(records[i].faults, kNoFault);
  }
  seams.display.update();
  EXPECT_EQ(seams.display.read().tick, records.back().tick);
}

TEST_F(ServoLoopTest, CountsTheTimesOfEveryTickThatItRuns) {
  ServoLoop loop(arm, description, {1000}, seams);
  EXPECT_EQ(loop.processorShare(), 0);
  loop.start();
  waitForTicks(100);
  EXPECT_GT(loop.processorShare(), 0);
  loop.stop();
  const std::vector<TickRecord> records = drain();
  const TimeDistribution wakeUps = seams.wakeUps.distribution();
  EXPECT_EQ(wakeUps.total, records.size());
  EXPECT_EQ(seams.ticks.distribution().total, records.size());
  EXPECT_EQ(records.size() + records.back().missedTicks, records.back().tick + 1);  // no grid point is forgotten
  std::int32_t latest = 0;
  for (const TickRecord& record : records) latest = std::max(latest, record.wakeLateness);
  EXPECT_EQ(wakeUps.longest, latest);
  EXPECT_GT(loop.processorShare(), 0);
  EXPECT_LE(loop.processorShare(), 1);
}

TEST(ServoPace, SleepsThreeQuartersOfThePeriodAtLeast) {
  using std::chrono::microseconds;
  EXPECT_EQ((ServoPace{1000, microseconds(50)}.spinNs()), 50'000);
  EXPECT_EQ((ServoPace{8000, microseconds(50)}.spinNs()), 31'250);
  EXPECT_EQ((ServoPace{1000, microseconds(0)}.spinNs()), 0);
  EXPECT_EQ((ServoPace{1000, microseconds(-1)}.spinNs()), 0);
}

TEST_F(ServoLoopTest, DoesTheSameArithmeticAsTheTickAlone) {
  ServoLoop loop(arm, description, {1000}, seams);
  loop.start();
  waitForTicks(100);
  loop.stop();
  const HapticTick tick(description, 1e-3);
  TickState state;
  for (const TickRecord& record : drain()) {
    const TickRecord again = tick({}, record.reading, state);
    EXPECT_EQ(again.command.jointRates, record.command.jointRates);
    EXPECT_EQ(again.desiredPosition, record.desiredPosition);
  }
}

TEST_F(ServoLoopTest, TakesANewSceneOverWhileItRuns) {
  ServoLoop loop(arm, description, {1000}, seams);
  loop.start();
  waitForTicks(20);
  for (std::uint32_t version = 1; version <= 200; ++version) {
    auto scene = std::make_shared<HapticScene>();
    scene->version = version;
    seams.scene.write(std::move(scene));
    if (version % 20 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  while (seams.display.read().sceneVersion != 200) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    seams.display.update();
  }
  loop.stop();
  std::uint32_t last = 0;
  for (const TickRecord& record : drain()) {
    EXPECT_GE(record.sceneVersion, last);
    last = record.sceneVersion;
  }
}

TEST_F(ServoLoopTest, StopsTheDeviceAndCanBeStartedAgain) {
  ServoLoop loop(arm, description, {1000}, seams);
  for (int run = 0; run < 2; ++run) {
    loop.start();
    EXPECT_TRUE(arm.running);
    waitForTicks(5);
    loop.stop();
    loop.stop();
    EXPECT_FALSE(arm.running);
    EXPECT_EQ(drain().front().tick, 0u);
    seams.display.write({});
    seams.display.update();
  }
}

TEST_F(ServoLoopTest, RefusesToStartWithoutAScene) {
  ServoSeams empty(1000);
  ServoLoop loop(arm, description, {1000}, empty);
  EXPECT_THROW(loop.start(), std::logic_error);
  EXPECT_FALSE(arm.running);
}

}  // namespace
}  // namespace haptiv
