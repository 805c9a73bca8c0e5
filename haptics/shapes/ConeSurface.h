#pragma once

#include "haptics/shapes/ShapeDistance.h"

namespace haptiv {

/// Nearest surface point of a cone: face 0 is the side, 1 the base at -axes.col(1). Realtime-safe: yes.
SurfacePoint nearestOnCone(const Shape& shape, const Vector3& p_W) noexcept;
/// The same on a given face, prolonged beyond its rim. Realtime-safe: yes.
SurfacePoint onConeFace(const Shape& shape, const Vector3& p_W, int face) noexcept;

}  // namespace haptiv
