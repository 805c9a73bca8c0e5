#pragma once

#include "haptics/geometry/SurfacePoint.h"
#include "haptics/shapes/Shape.h"

namespace haptiv {

/// Nearest point of the surface; exact for every kind, inside and outside, in W. An open mesh has no inside.
/// Realtime-safe: yes.  Never NaN for finite input, degenerate shapes included.
SurfacePoint nearestSurface(const Shape& shape, const Vector3& p_W) noexcept;

/// The same with the face given, prolonged beyond its rim: where a face has gone that was touched before. A triangle is
/// not prolonged, and has no inside.
/// Realtime-safe: yes.
SurfacePoint surfaceOfFace(const Shape& shape, const Vector3& p_W, int face) noexcept;

/// Axis-aligned bounds of a shape, in W.
Bounds boundsOf(const Shape& shape) noexcept;

}  // namespace haptiv
