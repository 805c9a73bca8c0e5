#pragma once

#include <algorithm>
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

/// M v, summed from the left: to the last bit as TwoBoxes.h has it.
inline Vector3 sumOfColumns(const Matrix3& M, const Vector3& v) noexcept {
  return M.col(0) * v.x() + M.col(1) * v.y() + M.col(2) * v.z();
}

/// A point as seen from a straight box: where it is along the normals, and how far beyond their faces.
struct BesideBox {
  BesideBox(const StraightBox& box, const Vector3& p_W) noexcept
      : along(sumOfColumns(box.normals, p_W - box.centre)), gap(along.cwiseAbs() - box.half) {}
  Vector3 along;  ///< [m]
  Vector3 gap;    ///< [m]; its largest entry is no larger than the distance
};

/// Nearest point of the surface, exact, inside and outside. Faces as nearestOnBox. Realtime-safe: yes.
inline SurfacePoint nearestOnStraightBox(const StraightBox& box, const BesideBox& point) noexcept {
  const Vector3 &along = point.along, &gap = point.gap;
  Eigen::Index most = gap[1] > gap[0] ? 1 : 0;  // faced
  most = gap[2] > gap[most] ? 2 : most;
  const double side = std::copysign(1.0, along[most]);
  SurfacePoint nearest{gap[most], side * box.normals.row(most), static_cast<int>(2 * most + (side < 0 ? 1 : 0))};
  if (!(gap[most] > StraightBox::kOutside)) return nearest;
  const Vector3 beyond(std::copysign(std::max(gap[0], 0.0), along[0]), std::copysign(std::max(gap[1], 0.0), along[1]),
                       std::copysign(std::max(gap[2], 0.0), along[2]));
  nearest.distance = std::sqrt(beyond.x() * beyond.x() + beyond.y() * beyond.y() + beyond.z() * beyond.z());
  nearest.normal = sumOfColumns(box.normals.transpose(), beyond) / nearest.distance;
  return nearest;
}

}  // namespace haptiv
