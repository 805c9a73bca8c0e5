#pragma once

#include "device/types.h"

namespace haptiv {

/// Nearest point of a triangle, its edges and corners included. Triangles that are lines or points are what they look
/// like: never NaN for finite input. Realtime-safe: yes.
Vector3 closestOnTriangle(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c) noexcept;

}  // namespace haptiv
