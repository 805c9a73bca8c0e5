#pragma once

#include "haptics/contact/ContactSet.h"

namespace haptiv {

/// IF in wall THEN the wall's law along its normal ELSE free motion.
///
/// f = k d + b v_in along the outward normal while d > 0, never pulling           [paper, eqs. (26), (27)]
///
/// d is how far the wall holds the ball back: from the ball to the proxy, the nearest place to which the ball could
/// have come without passing a wall. For one wall that is the depth of the ball's surface. The proxy is remembered, so
/// that the ball cannot be pushed out on the far side of a thin wall, nor under the next wall of a corner; through a
/// mesh it cannot go at all. In the free it is where the ball is.
/// Where walls hold the ball together, each takes its share d of the way out. It damps the part d / D of the speed into
/// it, of the ball's depth D in it: the force is continuous as another wall joins in, and two walls on one spot do not
/// feel twice as stiff. The dampers only take energy.
/// Where the proxy slips over an edge under a ball that is pressed deeper than its radius, it goes a sixteenth of the
/// radius a tick, so that the force turns, and does not step.
/// Friction: contact/Friction.h. Hysteresis: contact/Hysteresis.h.
///
/// @param contacts  in: of the tick before; out: of this one
/// @return          sum of the walls' forces on the ball, in W [N]
/// Realtime-safe: yes.  Thread: servo.
Vector3 renderWalls(const HapticScene& scene, const ToolMotion& tool, ContactSet& contacts) noexcept;

}  // namespace haptiv
