#include "haptics/shapes/StraightBoxSurface.h"

#include <Eigen/Geometry>

namespace haptiv {

std::optional<StraightBox> straightBox(const Shape& shape) noexcept {
  constexpr double kRightAngle = 1e-6;
  const Matrix3& axes = shape.axes;
  const Vector3 lengths = axes.colwise().norm().transpose();
  const double volume = lengths.prod();
  if (!(volume > 0) || !std::isfinite(volume)) return std::nullopt;
  StraightBox box;
  box.centre = shape.centre;
  const Matrix3 unit = axes.array().rowwise() / lengths.transpose().array();
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Index j = (i + 1) % 3, k = (i + 2) % 3;
    if (!(std::abs(unit.col(i).dot(unit.col(j))) <= kRightAngle)) return std::nullopt;
    const Vector3 across = unit.col(j).cross(unit.col(k)).normalized();
    box.normals.row(i) = across.dot(unit.col(i)) < 0 ? Vector3(-across) : across;
    box.half[i] = box.normals.row(i).dot(axes.col(i));
  }
  return box;
}

}  // namespace haptiv
