#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "haptics/servo/FastLoop.h"
#include "tests/haptics/tick/ReadingOf.h"

namespace haptiv::testing {

inline constexpr double kRate = 1000;

/// A ball at the arm's home, and a wall in front of it.
class HapticTickTest : public ::testing::Test {
 protected:
  HapticTickTest() {
    const Vector3 home = Vishard10(description.links).forward(start).position;
    Wall wall;
    wall.id = 1;
    wall.shape.centre = home + Vector3(0.115, 0, 0);  // its face is 5 mm from the ball
    wall.shape.axes = Vector3(0.1, 0.2, 0.2).asDiagonal();
    scene.version = 1;
    scene.walls = {wall};
    computeBounds(scene);
  }

  /// The force on the handle, in T, that is `force_B` at the start; the orientation is held.
  Vector3 inTool(const Vector3& force_B) const {
    return Vishard10(description.links).forward(start).rotation.transpose() * force_B;
  }
  std::vector<TickRecord> run(const HapticScene& of, const Vector3& force_B, int ticks) const {
    IdealArm arm(description, start, inTool(force_B));
    std::vector<TickRecord> records;
    runFast(arm, description, kRate, of, static_cast<std::uint64_t>(ticks), [&](const TickRecord& record) {
      records.push_back(record);
      return true;
    });
    return records;
  }

  /// A session whose operator is about to press the dead-man.
  TickState ready() const {
    TickState state;
    tick(scene, released(readingOf(description, start)), state);
    return state;
  }

  DeviceDescription description = loadDeviceDescription("vishard10");
  JointVector start = description.homeAngles;
  HapticScene scene;
  HapticTick tick = [this] {
    description.sensor.forceNoise = description.sensor.torqueNoise = 0;  // as these readings are
    return HapticTick(description, 1 / kRate);
  }();
};

}  // namespace haptiv::testing
