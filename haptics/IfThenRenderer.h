#pragma once

#include <array>

#include "haptics/HapticScene.h"

namespace haptiv {

/// The ball as the laws see it: centre [m], velocity [m/s], in W, and radius [m].
struct ToolMotion {
  Vector3 position = Vector3::Zero();
  Vector3 velocity = Vector3::Zero();
  double radius = 0.01;
};

/// One wall that the ball touches.
struct Contact {
  ShapeId id = 0;
  std::int32_t wall = 0;             ///< index into HapticScene::walls
  std::int32_t face = 0;             ///< by which the ball came in; kept until it has left
  double depth = 0;                  ///< penetration of the ball's surface [m], > 0
  Vector3 normal = Vector3::UnitZ();   ///< outward, in W
  Vector3 force = Vector3::Zero();   ///< on the ball, in W [N]
};

/// The walls in contact, deepest first dropped last: at most kMaxContacts are felt at once.
struct ContactSet {
  static constexpr int kMaxContacts = 16;
  std::array<Contact, kMaxContacts> contact{};
  int count = 0;
};

/// IF in wall THEN the wall's law along its normal ELSE free motion.
///
/// f = k d + b v_in along the outward normal while d > 0, never pulling           [paper, eqs. (26), (27)]
/// A ball whose centre has passed a face is held by that face until it leaves the shape, so that it cannot be
/// pushed out on the far side of a thin wall.
///
/// @param contacts  in: of the tick before; out: of this one
/// @return          sum of the walls' forces on the ball, in W [N]
/// Realtime-safe: yes.  Thread: servo.
Vector3 renderWalls(const HapticScene& scene, const ToolMotion& tool, ContactSet& contacts) noexcept;

}  // namespace haptiv
