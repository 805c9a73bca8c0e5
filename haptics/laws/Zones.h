#pragma once

#include "haptics/laws/IfThenRenderer.h"
#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// Force of all zones on the ball; overlapping zones add up.
///
/// viscous: f = -b v.  spring: f = k (|a - x| - l) along a - x.  rubber band: the same where |a - x| > l, else none.
/// A zone takes hold as the ball goes in: the force grows with the part of the ball's diameter that is inside,
/// so it is continuous across the border. A mesh that is not closed bounds no zone.
///
/// @param inside  out: how many zones the ball is in, wholly or partly
/// Realtime-safe: yes.  Thread: servo.
Vector3 renderZones(const HapticScene& scene, const ToolMotion& tool, int& inside) noexcept;

}  // namespace haptiv
