#include "haptics/shapes/SphereSurface.h"

#include "haptics/geometry/UnitVector.h"

namespace haptiv {

SurfacePoint nearestOnSphere(const Shape& shape, const Vector3& p_W) noexcept {
  const Vector3 d = p_W - shape.centre;
  return {d.norm() - shape.axes.col(0).norm(), unitOr(d, unitOr(shape.axes.col(1), Vector3::UnitZ())), 0};
}

}  // namespace haptiv
