#pragma once

#include "haptics/contact/ContactSet.h"

namespace haptiv {

/// Brings the proxy as near to the goal as the walls let it: first held by the exact walls of the tick before, to find
/// out which are around, then by these. What holds it are the contacts.
///
/// @param goal  to which the proxy is drawn, p_WT [m]
/// @param way   how far the proxy may go while it is held [m]
/// Realtime-safe: yes.
void touchWalls(const HapticScene& scene, const Vector3& goal, double radius, double way,
                ContactSet& contacts) noexcept;

}  // namespace haptiv
