#pragma once

#include "haptics/shapes/ShapeDistance.h"

namespace haptiv {

/// Nearest surface point of a cylinder: face 0 is the side, 1 the top at +axes.col(1), 2 the bottom.
/// Realtime-safe: yes.
SurfacePoint nearestOnCylinder(const Shape& shape, const Vector3& p_W) noexcept;
/// The same on a given face, prolonged beyond its rim. Realtime-safe: yes.
SurfacePoint onCylinderFace(const Shape& shape, const Vector3& p_W, int face) noexcept;

}  // namespace haptiv
