#pragma once

#include "haptics/contact/NearSurfaces.h"

namespace haptiv {

/// The exact walls around a place, as far as a ball's diameter, by rising number; the nearest ones where they are too
/// many. Realtime-safe: yes.
void findWallsAround(const HapticScene& scene, const Vector3& place, double radius, NearSurfaces& near) noexcept;

}  // namespace haptiv
