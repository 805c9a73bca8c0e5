/// Ticks, their parts and the seams, without a loop around them: whatever state they are in.
#include "tests/realtime/HiddenCalls.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <mutex>

#include "haptics/servo/ServoLoop.h"
#include "tests/haptics/tick/ReadingOf.h"
#include "tests/realtime/CrowdedScene.h"
#include "tests/realtime/ServoRun.h"

namespace haptiv {
namespace {

using testing::hiddenCallsOf;
using testing::readingOf;

TEST(HiddenCalls, AreCounted) {
  std::mutex mutex;
  EXPECT_EQ(hiddenCallsOf([] { std::free(std::malloc(16)); }).heap, 2u);
  const auto growing = [] {
    const Eigen::VectorXd heap = Eigen::VectorXd::Ones(32);
    const volatile double sum = heap.sum();
    static_cast<void>(sum);
  };
  EXPECT_GE(hiddenCallsOf(growing).heap, 2u);
  EXPECT_EQ(hiddenCallsOf([&] { const std::lock_guard lock(mutex); }).locks, 1u);
}

/// More contacts than are felt, edits, every strategy and way of control, and faults.
TEST(HiddenCalls, HappenInNoTick) {
  const DeviceDescription description = loadDeviceDescription("vishard10");
  HapticScene scene = testing::crowdedScene(testing::homeOf(description), 1);
  for (const bool withBounds : {false, true}) {
    if (withBounds) computeBounds(scene);
    const HapticTick tick(description, 1e-3);
    TickState state;
    int contacts = 0, torques = 0;
    const testing::HiddenCalls calls = hiddenCallsOf([&] {
      for (int i = 0; i < 300; ++i) {
        scene.version = static_cast<std::uint32_t>(i / 50);
        scene.resolution = ResolutionChoice{static_cast<Strategy>(i / 20 % 4), static_cast<Solution>(i / 100 % 2)};
        scene.control = ControlChoice{static_cast<DisplayMode>(i / 10 % 3), static_cast<JointController>(i / 30 % 2),
                                      static_cast<OrientationMode>(i / 60 % 2), i % 20 < 10};
        DeviceReading reading = readingOf(description, description.homeAngles, {1, 2, 3});
        reading.inputs = i < 10 ? 0 : kInputDeadMan;
        reading.connected = i < 250;
        const TickRecord record = tick(scene, reading, state);
        contacts = std::max(contacts, record.contacts);
        torques += record.command.mode == DriveMode::torque;
      }
    });
    EXPECT_EQ(calls.heap, 0u);
    EXPECT_EQ(calls.locks, 0u);
    EXPECT_GT(contacts, 0);
    EXPECT_GT(torques, 0);
    EXPECT_NE(state.session.faults, kNoFault);
  }
}

TEST(HiddenCalls, HappenInNoHandOver) {
  ServoSeams seams(1000);
  seams.scene.write(std::make_shared<const HapticScene>());
  const testing::HiddenCalls calls = hiddenCallsOf([&] {
    seams.scene.update();
    for (int i = 0; i < 9000; ++i) {
      seams.log.push({});
      seams.display.write({});
    }
  });
  EXPECT_EQ(calls.heap, 0u);
  EXPECT_EQ(calls.locks, 0u);
}

}  // namespace
}  // namespace haptiv
