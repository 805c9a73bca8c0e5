#pragma once

#include <cmath>
#include <optional>

#include "haptics/shapes/ShapeDistance.h"
#include "haptics/shapes/StraightBox.h"

namespace haptiv {

/// A box as a straight one; nothing where it is skewed or has no volume.
///
/// Up to a millionth the angles are right ones: transforms come in single precision. The distances then differ from
/// those of the skewed box by that part of the box's size. Realtime-safe: yes.
std::optional<StraightBox> straightBox(const Shape& box) noexcept;

/// A point as seen from a straight box: where it is along the normals, and how far beyond their faces.
struct BesideBox {
  BesideBox(const StraightBox& box, const Vector3& p_W) noexcept
      : along(box.normal.transpose() * (p_W - box.centre)), gap(along.cwiseAbs() - box.half) {}
  Vector3 along;  ///< [m]
  Vector3 gap;    ///< [m]; its largest entry is no larger than the distance
};

/// Nearest point of the surface, exact, inside and outside. Faces as nearestOnBox. Realtime-safe: yes.
inline SurfacePoint nearestOnStraightBox(const StraightBox& box, const BesideBox& point) noexcept {
  Eigen::Index most = 0;  // faced
  for (Eigen::Index i = 1; i < 3; ++i) {
    if (point.gap[i] > point.gap[most]) most = i;
  }
  const double side = point.along[most] < 0 ? -1 : 1;
  SurfacePoint nearest{point.gap[most], side * box.normal.col(most), static_cast<int>(2 * most + (side < 0 ? 1 : 0))};
  const int beside = (point.gap[0] > 0 ? 1 : 0) + (point.gap[1] > 0 ? 1 : 0) + (point.gap[2] > 0 ? 1 : 0);
  if (beside < 2) return nearest;  // inside, or above that face
  const Vector3 beyond = point.gap.cwiseMax(0).cwiseProduct(point.along.cwiseSign());
  nearest.distance = beyond.norm();
  if (nearest.distance > 1e-12 * box.half.maxCoeff()) nearest.normal = box.normal * (beyond / nearest.distance);
  return nearest;
}

}  // namespace haptiv
