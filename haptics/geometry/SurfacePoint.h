#pragma once

#include "device/types.h"

namespace haptiv {

/// The surface of a shape as seen from a point.
struct SurfacePoint {
  double distance = 0;                ///< signed [m]: negative inside
  Vector3 normal = Vector3::UnitZ();  ///< outward unit normal, in W
  int face = 0;                       ///< which of the shape's faces (box 6, cylinder 3, cone 2, sphere 1, triangles)
};

}  // namespace haptiv
