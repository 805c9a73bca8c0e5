#pragma once

#include "haptics/shapes/Shape.h"

namespace haptiv {

/// A point beside a shape of revolution, reduced to the half plane through the axis: (radial, along).
struct AxialPoint {
  Vector3 axis;       ///< unit, from the base to the top, in W
  Vector3 outward;    ///< unit, from the axis to the point, in W
  double along;       ///< [m] from the centre, on the axis
  double radial;      ///< [m] from the axis, >= 0
  double halfHeight;  ///< of the shape [m]
  double radius;      ///< of the shape [m]

  /// From the half plane back to W.
  Vector3 direction(double radialPart, double alongPart) const noexcept {
    return radialPart * outward + alongPart * axis;
  }
};

/// For cylinders and cones. Degenerate shapes get some axis and some outward direction.
/// Realtime-safe: yes.
AxialPoint axialPoint(const Shape& shape, const Vector3& p_W) noexcept;

}  // namespace haptiv
