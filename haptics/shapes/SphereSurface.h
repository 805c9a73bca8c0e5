#pragma once

#include "haptics/shapes/ShapeDistance.h"

namespace haptiv {

/// Nearest surface point of a sphere; its only face is 0. Realtime-safe: yes.
SurfacePoint nearestOnSphere(const Shape& shape, const Vector3& p_W) noexcept;

}  // namespace haptiv
