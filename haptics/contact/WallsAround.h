#pragma once

#include "haptics/contact/NearSurfaces.h"

namespace haptiv {

/// The exact walls nearer to a place than `reach` [m], by rising number; the nearest ones where they are too many.
/// Realtime-safe: yes.
void findWallsAround(const HapticScene& scene, const Vector3& place, double reach, NearSurfaces& near) noexcept;

}  // namespace haptiv
