#pragma once

#include "haptics/contact/NearSurfaces.h"

namespace haptiv {

/// How a ball moves.
struct BallCourse {
  Vector3 step;   ///< in a tick, in W [m]
  double radius;  ///< [m]
};

/// The exact walls nearer to a place than `reach` [m], by rising number; the nearest ones where they are too many.
/// Realtime-safe: yes.
/// @param boxes  of the scene's tree, from the ticks before; they change nothing but the time that it takes
void findWallsAround(const HapticScene& scene, const Vector3& place, double reach, const BallCourse& course,
                     RememberedBoxes& boxes, NearSurfaces& near) noexcept;

}  // namespace haptiv
