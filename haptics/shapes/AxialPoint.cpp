#include "haptics/shapes/AxialPoint.h"

#include <Eigen/Geometry>

#include "haptics/geometry/UnitVector.h"

namespace haptiv {

AxialPoint axialPoint(const Shape& shape, const Vector3& p_W) noexcept {
  const Vector3 x = shape.axes.col(0);
  const Vector3 y = shape.axes.col(1);
  const Vector3 z = shape.axes.col(2);
  AxialPoint point;
  point.halfHeight = y.norm();
  point.radius = x.norm();
  point.axis = unitOr(y, unitOr(z.cross(x), Vector3::UnitZ()));
  const Vector3 d = p_W - shape.centre;
  point.along = d.dot(point.axis);
  Vector3 radial = d - point.along * point.axis;
  radial -= radial.dot(point.axis) * point.axis;            // once more, for points all but on the axis
  if (radial.norm() <= 1e-15 * d.norm()) radial.setZero();  // what is left there is rounding
  point.radial = radial.norm();
  point.outward = unitOr(radial, unitOr(x, point.axis.unitOrthogonal()));
  return point;
}

}  // namespace haptiv
