/// The servo's path under clang's RealtimeSanitizer, which ends the program at the first call that can make it wait.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <limits>
#include <mutex>

#include "device/Nonblocking.h"
#include "haptics/servo/FastLoop.h"
#include "tests/haptics/tick/ReadingOf.h"
#include "tests/realtime/CrowdedScene.h"
#include "tests/realtime/ServoRun.h"

namespace haptiv {
namespace {

using testing::crowdedScene;
using testing::homeOf;
using testing::readingOf;

class RealtimeSanitizer : public ::testing::TestWithParam<const char*> {
 protected:
  DeviceDescription description = loadDeviceDescription(GetParam());
};
INSTANTIATE_TEST_SUITE_P(BuiltIn, RealtimeSanitizer, ::testing::Values("vishard10", "anthropomorphic7", "falcon"));

TEST_P(RealtimeSanitizer, HasNothingToSayOfHalfASecondOfTheServo) {
  SimulatedDevice arm = testing::pulledArm(description);
  const std::vector<TickRecord> records = testing::runServo(arm, description, 500);
  EXPECT_TRUE(std::ranges::any_of(records, [](const TickRecord& record) { return record.contacts > 0; }));
  EXPECT_TRUE(std::ranges::any_of(records, [](const TickRecord& record) { return record.zones > 0; }));
  EXPECT_GT(records.back().sceneVersion, records.front().sceneVersion);
}

TEST_P(RealtimeSanitizer, HasNothingToSayOfFaults) {
  HapticScene scene = crowdedScene(homeOf(description), 1);
  computeBounds(scene);
  const HapticTick tick(description, 1e-3);
  DeviceReading gone = readingOf(description, description.homeAngles);
  gone.connected = false;
  DeviceReading saturated = readingOf(description, description.homeAngles);
  saturated.sensorCounts.fill(std::numeric_limits<std::int16_t>::min());
  DeviceReading elsewhere;
  elsewhere.encoderCounts.fill(std::numeric_limits<std::int32_t>::max());
  for (const DeviceReading& bad : {gone, saturated, elsewhere}) {
    TickState state;
    for (int i = 0; i < 20; ++i) tick(scene, readingOf(description, description.homeAngles), state);
    for (int i = 0; i < 20; ++i) tick(scene, bad, state);
    EXPECT_NE(state.session.faults, kNoFault);
  }
}

/// An arm whose read does what it must not.
class WaywardArm : public testing::IdealArm {
 public:
  WaywardArm(const DeviceDescription& description, std::function<void()> slip)
      : IdealArm(description, description.homeAngles, Vector3::Zero()), slip_(std::move(slip)) {}
  DeviceReading read() noexcept override {
    slip_();
    return IdealArm::read();
  }

 private:
  std::function<void()> slip_;
};

/// One tick with such a read.
void slipIn(const DeviceDescription& description, std::function<void()> slip) {
  WaywardArm arm(description, std::move(slip));
  runFast(arm, description, 1000, HapticScene{}, 1, [](const TickRecord&) { return true; });
}

TEST_P(RealtimeSanitizer, EndsTheProgramAtAHiddenCall) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto allocate = [] {
    void* const volatile hidden = std::malloc(16);  // or the compiler sees that nobody needs it
    std::free(hidden);
  };
  EXPECT_DEATH(slipIn(description, allocate), "RealtimeSanitizer.*malloc");
  std::mutex mutex;
  EXPECT_DEATH(slipIn(description, [&] { const std::lock_guard lock(mutex); }),
               "RealtimeSanitizer.*pthread_mutex_lock");
  EXPECT_DEATH(slipIn(description, [] { ::usleep(1); }), "RealtimeSanitizer.*usleep");
  EXPECT_DEATH(slipIn(description, [] { ::write(2, "", 0); }), "RealtimeSanitizer.*write");
}

TEST_P(RealtimeSanitizer, LetsADevicesOwnInputAndOutputThrough) {
  bool isDone = false;
  slipIn(description, [&] {
    const DeviceIo io;
    isDone = ::write(2, "", 0) == 0;
  });
  EXPECT_TRUE(isDone);
}

}  // namespace
}  // namespace haptiv
