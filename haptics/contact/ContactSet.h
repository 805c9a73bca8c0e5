#pragma once

#include <algorithm>
#include <array>

#include "haptics/contact/RememberedBlocks.h"
#include "haptics/index/RememberedBoxes.h"
#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// The ball as the laws see it: centre [m], velocity [m/s], in W, and radius [m].
struct ToolMotion {
  Vector3 position = Vector3::Zero();
  Vector3 velocity = Vector3::Zero();
  double radius = 0.01;
};

/// One place of a wall that the ball touches.
struct Contact {
  ShapeId id = 0;
  std::int32_t wall = 0;              ///< index into HapticScene::walls
  std::int32_t face = 0;              ///< at which the ball was stopped; of a mesh, the triangle
  double depth = 0;                   ///< how far the wall holds the ball back [m]; 0: only where the others press it
  Vector3 normal = Vector3::UnitZ();  ///< outward, in W
  double offset = 0;                  ///< the wall leaves the ball's centre x where normal . x >= offset [m]
  double slack = 0;                   ///< part of the depth that hysteresis takes away [m]
  Vector3 force = Vector3::Zero();    ///< on the ball, in W [N]

  double elasticDepth() const noexcept { return depth - slack; }  ///< that the wall's spring has [m]
};

/// The walls in contact: at most kMaxContacts, the nearest ones; and what is remembered of how the ball came there.
struct ContactSet {
  static constexpr int kMaxContacts = 16;
  std::array<Contact, kMaxContacts> contact{};
  int count = 0;
  bool started = false;
  bool sliding = false;                       ///< friction does not hold the proxy
  bool wedged = false;                        ///< an edit left the proxy no place: it moves only with the ball
  std::uint32_t sceneVersion = 0;             ///< for which `wall` holds
  Vector3 surfacePosition = Vector3::Zero();  ///< the proxy: the ball's centre as the walls allow it, p_WT [m]
  Vector3 goal = Vector3::Zero();             ///< to which it was drawn [m]
  Vector3 toolPosition = Vector3::Zero();     ///< p_WT [m]
  Vector3 frictionOffset = Vector3::Zero();   ///< from there to where the proxy was to go, in W [m]
  RememberedBlocks blocks;                    ///< of the meshes around the proxy
  RememberedBoxes boxes;                      ///< of the walls around the proxy

  /// How many walls are touched: a mesh may be so in several places.
  int walls() const noexcept {
    int found = 0;
    for (const Contact* each = begin(); each != end(); ++each) {
      found += std::none_of(begin(), each, [&](const Contact& other) { return other.wall == each->wall; }) ? 1 : 0;
    }
    return found;
  }

  Contact* begin() noexcept { return contact.data(); }
  Contact* end() noexcept { return contact.data() + count; }
  const Contact* begin() const noexcept { return contact.data(); }
  const Contact* end() const noexcept { return contact.data() + count; }
};

/// Of the scene for whose version the contact holds.
inline const Wall& wallOf(const HapticScene& scene, const Contact& contact) noexcept {
  return scene.walls[static_cast<std::size_t>(contact.wall)];
}

}  // namespace haptiv
