#pragma once

#include "haptics/shapes/ShapeDistance.h"

namespace haptiv {

/// Nearest surface point of a box, which may be a skewed one (a parallelepiped): faces 2 i and 2 i + 1 are those at
/// +axes.col(i) and -axes.col(i). A box without volume is its own surface: never inside.
/// Realtime-safe: yes.
SurfacePoint nearestOnBox(const Shape& shape, const Vector3& p_W) noexcept;
/// The same on the plane of a given face. Realtime-safe: yes.
SurfacePoint onBoxFace(const Shape& shape, const Vector3& p_W, int face) noexcept;

}  // namespace haptiv
