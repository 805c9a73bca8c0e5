#pragma once

#include "device/described/DeviceDescription.h"
#include "haptics/scene/HapticScene.h"
#include "tests/haptics/RandomShapes.h"
#include "tests/haptics/meshes/SampleMeshes.h"

namespace haptiv::testing {

/// Walls and zones of every kind around the ball, meshes among them, rough and with hysteresis; more of them touch it
/// than can be felt at a time. Another version moves them a little.
inline HapticScene crowdedScene(const Vector3& home, std::uint32_t version) {
  RandomShapes random(1);
  HapticScene scene;
  scene.version = version;
  for (int i = 0; i < 40; ++i) {
    Wall wall;
    wall.id = static_cast<ShapeId>(i);
    wall.shape = random.shape(static_cast<Shape::Kind>(i % 4), 0.05);
    wall.shape.centre += home + 1e-4 * version * random.direction();
    wall.surface.staticFriction = 0.1 * (i % 3);
    wall.surface.dynamicFriction = 0.05 * (i % 3);
    wall.surface.hysteresis = 1e-4 * (i % 2);
    if (i % 5 == 0) {
      wall.shape.kind = Shape::Kind::mesh;
      wall.shape.mesh = boxSoup(wall.shape.centre, wall.shape.axes, 1 + i).mesh();
    }
    scene.walls.push_back(wall);
    Zone zone;
    zone.kind = static_cast<Zone::Kind>(i % 3);
    zone.shape = wall.shape;
    scene.zones.push_back(zone);
  }
  return scene;
}

}  // namespace haptiv::testing
