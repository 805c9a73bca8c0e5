#include "haptics/shapes/CylinderSurface.h"

#include <cmath>

#include "haptics/shapes/AxialPoint.h"

namespace haptiv {
namespace {

enum CylinderFace { kRound, kTop, kBottom };

SurfacePoint onThatFace(const AxialPoint& point, int face) noexcept {
  if (face == kTop) return {point.along - point.halfHeight, point.axis, kTop};
  if (face == kBottom) return {-point.along - point.halfHeight, -point.axis, kBottom};
  return {point.radial - point.radius, point.outward, kRound};
}

}  // namespace

SurfacePoint onCylinderFace(const Shape& shape, const Vector3& p_W, int face) noexcept {
  return onThatFace(axialPoint(shape, p_W), face);
}

SurfacePoint nearestOnCylinder(const Shape& shape, const Vector3& p_W) noexcept {
  const AxialPoint point = axialPoint(shape, p_W);
  const SurfacePoint side = onThatFace(point, kRound);
  const SurfacePoint cap = onThatFace(point, point.along < 0 ? kBottom : kTop);
  const SurfacePoint& nearer = side.distance >= cap.distance ? side : cap;
  if (side.distance <= 0 || cap.distance <= 0) return nearer;
  // Beyond the side and beyond the cap: the rim is nearest.
  const double distance = std::hypot(side.distance, cap.distance);
  const Vector3 normal = (side.distance * side.normal + cap.distance * cap.normal) / distance;
  return {distance, normal, nearer.face};
}

}  // namespace haptiv
