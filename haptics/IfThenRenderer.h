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
  std::int32_t wall = 0;              ///< index into HapticScene::walls
  std::int32_t face = 0;              ///< at which the ball was stopped
  double depth = 0;                   ///< how far the wall holds the ball back [m]; 0: only where the others press it
  Vector3 normal = Vector3::UnitZ();  ///< outward, in W
  double offset = 0;                  ///< the wall leaves the ball's centre x where normal . x >= offset [m]
  Vector3 force = Vector3::Zero();    ///< on the ball, in W [N]
};

/// The walls in contact: at most kMaxContacts, the nearest ones.
struct ContactSet {
  static constexpr int kMaxContacts = 16;
  std::array<Contact, kMaxContacts> contact{};
  int count = 0;
  std::uint32_t sceneVersion = 0;             ///< for which `wall` holds
  Vector3 surfacePosition = Vector3::Zero();  ///< the ball's centre as the walls allow it, p_WT [m]
};

/// IF in wall THEN the wall's law along its normal ELSE free motion.
///
/// f = k d + b v_in along the outward normal while d > 0, never pulling           [paper, eqs. (26), (27)]
///
/// d is how far the wall holds the ball back: from the ball to the nearest place to which it could have come without
/// passing a wall. For one wall that is the depth of the ball's surface. The place is remembered (by the planes of the
/// contacts), so that the ball cannot be pushed out on the far side of a thin wall, nor under the next wall of a
/// corner. Where walls hold the ball together, each takes its share of the way out: the force is continuous as
/// another wall joins in, and two walls on one spot do not feel twice as stiff.
///
/// @param contacts  in: of the tick before; out: of this one
/// @return          sum of the walls' forces on the ball, in W [N]
/// Realtime-safe: yes.  Thread: servo.
Vector3 renderWalls(const HapticScene& scene, const ToolMotion& tool, ContactSet& contacts) noexcept;

}  // namespace haptiv
