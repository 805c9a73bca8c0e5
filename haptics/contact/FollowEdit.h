#pragma once

#include "haptics/contact/ContactSet.h"

namespace haptiv {

/// Brings the contacts and the proxy of the tick before to where the walls are now that the scene was edited.
///
/// A wall that moved under the ball takes its contact along, by the ball's size at most: one that jumped farther, or
/// is gone, has let go. A closed mesh that now has the proxy inside pushes it out at its nearest place.
/// Realtime-safe: yes; a search through each closed mesh around the proxy.
void followEdit(const HapticScene& scene, double radius, ContactSet& contacts) noexcept;

/// Where a proxy that starts at p_W may be: outside of closed meshes. Realtime-safe: yes.
Vector3 outsideMeshes(const HapticScene& scene, const Vector3& p_W, double radius) noexcept;

}  // namespace haptiv
