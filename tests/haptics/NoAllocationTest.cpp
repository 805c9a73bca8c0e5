#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

#include "haptics/HapticTick.h"
#include "haptics/ServoLoop.h"
#include "tests/haptics/MallocCounter.h"
#include "tests/haptics/RandomShapes.h"
#include "tests/haptics/ReadingOf.h"
#include "tests/haptics/meshes/SampleMeshes.h"

namespace haptiv {
namespace {

using testing::allocationsOfThisThread;
using testing::readingOf;

class NoAllocation : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!testing::countsAllocations()) GTEST_SKIP() << "the sanitizer has an allocator of its own";
  }
};

TEST_F(NoAllocation, IsWhatTheCounterWouldSee) {
  const std::size_t before = allocationsOfThisThread();
  void* volatile block = std::malloc(16);
  std::free(block);
  const Eigen::VectorXd heap = Eigen::VectorXd::Zero(32);
  EXPECT_EQ(heap.size(), 32);
  EXPECT_EQ(allocationsOfThisThread() - before, 2u);
}

/// Walls and zones of every kind, rough and with hysteresis, more contacts than are felt, an edit, and a fault.
TEST_F(NoAllocation, HappensInAnyTick) {
  DeviceDescription description = loadDeviceDescription("vishard10");
  description.sensor.forceNoise = description.sensor.torqueNoise = 0;  // as these readings are
  const Vector3 home = Vishard10(description.links).forward(description.homeAngles).position;
  testing::RandomShapes random(1);
  HapticScene scene;
  for (int i = 0; i < 40; ++i) {
    Wall wall;
    wall.id = static_cast<ShapeId>(i);
    wall.shape = random.shape(static_cast<Shape::Kind>(i % 4), 0.05);
    wall.shape.centre += home;
    wall.surface.staticFriction = 0.1 * (i % 3);
    wall.surface.dynamicFriction = 0.05 * (i % 3);
    wall.surface.hysteresis = 1e-4 * (i % 2);
    if (i % 5 == 0) {
      wall.shape.kind = Shape::Kind::mesh;
      wall.shape.mesh = testing::boxSoup(wall.shape.centre, wall.shape.axes, 1 + i).mesh();
    }
    scene.walls.push_back(wall);
    Zone zone;
    zone.kind = static_cast<Zone::Kind>(i % 3);
    zone.shape = wall.shape;
    scene.zones.push_back(zone);
  }
  for (const bool withBounds : {false, true}) {
    if (withBounds) computeBounds(scene);
    const HapticTick tick(description, 1e-3);
    TickState state;
    int contacts = 0, torques = 0;
    const std::size_t before = allocationsOfThisThread();
    for (int i = 0; i < 200; ++i) {
      scene.version = static_cast<std::uint32_t>(i / 50);
      scene.resolution = ResolutionChoice{static_cast<Strategy>(i / 20 % 4), static_cast<Solution>(i / 100 % 2)};
      scene.control = ControlChoice{static_cast<DisplayMode>(i / 10 % 3), static_cast<JointController>(i / 30 % 2),
                                    static_cast<OrientationMode>(i / 60 % 2), i % 20 < 10};
      DeviceReading reading = readingOf(description, description.homeAngles, {1, 2, 3});
      if (i == 0) reading.inputs = 0;  // a dead-man that is released first, then pressed
      if (i == 190) reading.trips = kTripWatchdog;
      const TickRecord record = tick(scene, reading, state);
      contacts = std::max(contacts, record.contacts);
      torques += record.command.mode == DriveMode::torque;
    }
    EXPECT_EQ(allocationsOfThisThread() - before, 0u);
    EXPECT_GT(contacts, 0);
    EXPECT_GT(torques, 0);
  }
}

TEST_F(NoAllocation, HappensInHandingOverScenesAndRecords) {
  ServoSeams seams(1000);
  seams.scene.write(std::make_shared<const HapticScene>());
  const std::size_t before = allocationsOfThisThread();
  seams.scene.update();
  for (int i = 0; i < 9000; ++i) {
    seams.log.push({});
    seams.display.write({});
  }
  EXPECT_EQ(allocationsOfThisThread() - before, 0u);
}

}  // namespace
}  // namespace haptiv
