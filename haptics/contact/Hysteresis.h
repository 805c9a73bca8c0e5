#pragma once

#include "haptics/contact/ContactSet.h"

namespace haptiv {

/// Hysteresis of a surface: on the way out the force is that of a place shallower by h than on the way in. It dispels
/// chatter and makes a wall feel harder [paper, section V-B; it gives no equation].
///
/// f = k (d - s), and the slack s [m] goes against the depth:  ds = -dd, kept within 0 <= s <= min(h, d)
///
/// Going in, s = 0: f = k d. Coming out, s grows to h: f = k (d - h), zero over the last h. In between the force
/// changes twice as steeply, but continuously: a switch between the two curves would step, and a contact that is let go
/// only h outside of the wall would have to pull. A round trip of more than h takes k h (D - h) out of the motion, and
/// no closed way gives any energy: s only ever opposes it, as in a stop of Coulomb friction.
///
/// Of a wall that the ball touches in several places, d is the length of the sum of their depths along their normals.
struct WallSlacks {
  struct WallSlack {
    ShapeId id;
    double depth;  ///< d
    double slack;  ///< s
  };
  std::array<WallSlack, ContactSet::kMaxContacts> wall;
  std::size_t count = 0;
};

/// Of the walls in contact that have hysteresis. Realtime-safe: yes.
WallSlacks slacksOf(const HapticScene& scene, const ContactSet& contacts) noexcept;

/// Brings the slack of the contacts from what it was in the tick before to now. Realtime-safe: yes.
void takeUpSlack(const HapticScene& scene, const WallSlacks& before, ContactSet& now) noexcept;

}  // namespace haptiv
