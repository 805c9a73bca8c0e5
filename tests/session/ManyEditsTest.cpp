#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "app/session/SessionSeat.h"
#include "haptics/servo/ServeTick.h"
#include "tests/session/SessionFixtures.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

using namespace haptiv::testing;

constexpr std::uint32_t kEdits = 1000;

/// The wall of wallScene and a few hundred more, changed as a person might: another stiffness, a wall moved, one more,
/// one less.
HapticScene edited(test::Random& random, std::uint32_t version) {
  HapticScene scene = wallScene(random.between(500, 4000));
  scene.version = version;
  const auto others = static_cast<std::size_t>(random.between(100, 300));
  for (std::size_t i = 0; i < others; ++i) {
    Wall wall = scene.walls[0];
    wall.id = static_cast<ShapeId>(100 + i);
    wall.shape.centre = random.vector<Vector3>(-1, 1) + Vector3(-2, 0, 0);
    wall.shape.axes = random.vector<Vector3>(0.01, 0.1).asDiagonal();
    scene.walls.push_back(wall);
  }
  std::rotate(scene.walls.begin(), scene.walls.begin() + static_cast<std::ptrdiff_t>(others / 2), scene.walls.end());
  computeBounds(scene);
  return scene;
}

TEST(ManyEdits, LeaveNoSceneBehindButTheNewest) {
  test::Random random(1);
  SessionSetup setup = setupFor(wallScene());
  setup.liveHand = true;
  std::vector<std::weak_ptr<const HapticScene>> scenes;
  Session session(setup);
  for (std::uint32_t edit = 1; edit <= kEdits; ++edit) {
    auto scene = std::make_shared<const HapticScene>(edited(random, edit));
    scenes.push_back(scene);
    session.publish(std::move(scene), "");
  }
  TickRecord record;
  for (int wait = 0; wait < 1000 && record.sceneVersion != kEdits; ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    session.newest(record);
  }
  EXPECT_EQ(record.sceneVersion, kEdits);
  EXPECT_EQ(record.faults, kNoFault);
  session.stop();
  const auto alive = std::count_if(scenes.begin(), scenes.end(), [](const auto& scene) { return !scene.expired(); });
  EXPECT_LE(alive, 3);  // the slots of the triple buffer
}

/// A hand presses the ball against a wall that gets softer and stiffer, and another number, at every sixteenth tick.
TEST(ManyEdits, NeverStepTheForceNorLoseTheContact) {
  const SessionSetup setup = setupFor(wallScene(), {{0, {0, 0, 0}}, {0.5, {0.1, 0.02, 0}}});
  const auto device = simulatedDevice(setup, scriptedHand(setup));
  const HapticTick tick(setup.description, 1e-3);
  test::Random random(2);
  HapticScene scene = *setup.scene;
  TickState state;
  Vector3 last = Vector3::Zero();
  double largestStep = 0;
  device->start(1e-3);
  for (std::uint32_t i = 0; i < 1000 + 16 * kEdits; ++i) {
    if (i >= 1000 && i % 16 == 0) scene = edited(random, i);
    const TickRecord record = serveTick(
        *device, tick, [&]() noexcept -> const HapticScene& { return scene; }, state);
    ASSERT_EQ(record.faults, kNoFault);
    if (i >= 1000) {
      ASSERT_EQ(record.contacts, 1);
      largestStep = std::max(largestStep, (record.environmentForce - last).norm());
    }
    last = record.environmentForce;
  }
  device->stop();
  // An eightfold stiffness would step by more than 50 N; a ball let in over 100 ms swings by some newtons in a tick.
  EXPECT_LT(largestStep, 5);
}

}  // namespace
}  // namespace haptiv
