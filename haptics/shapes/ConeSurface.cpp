#include "haptics/shapes/ConeSurface.h"

#include <algorithm>
#include <cmath>

#include "haptics/shapes/AxialPoint.h"

namespace haptiv {
namespace {

enum ConeFace { kConeSide, kConeBase };

/// The slant line from the apex down to the rim, in the half plane (radial, along).
struct Slant {
  explicit Slant(const AxialPoint& point)
      : length(std::hypot(point.radius, 2 * point.halfHeight)),
        radial(length > 0 ? point.radius / length : 0),
        along(length > 0 ? -2 * point.halfHeight / length : -1) {}

  double length;
  double radial;  ///< unit direction from the apex to the rim
  double along;
};

SurfacePoint onBase(const AxialPoint& point) noexcept {
  return {-point.along - point.halfHeight, -point.axis, kConeBase};
}

SurfacePoint onSide(const AxialPoint& point, const Slant& slant) noexcept {
  const double distance = -slant.along * point.radial + slant.radial * (point.along - point.halfHeight);
  return {distance, point.direction(-slant.along, slant.radial), kConeSide};
}

/// From the point (radial, along) of the surface to the ball, for a point outside.
SurfacePoint from(const AxialPoint& point, double radial, double along, const SurfacePoint& face) noexcept {
  const double dr = point.radial - radial;
  const double da = point.along - along;
  const double distance = std::hypot(dr, da);
  const double size = std::max(point.radius, point.halfHeight);
  if (!(distance > 1e-12 * size)) return {distance, face.normal, face.face};
  return {distance, point.direction(dr / distance, da / distance), face.face};
}

}  // namespace

SurfacePoint onConeFace(const Shape& shape, const Vector3& p_W, int face) noexcept {
  const AxialPoint point = axialPoint(shape, p_W);
  return face == kConeBase ? onBase(point) : onSide(point, Slant(point));
}

SurfacePoint nearestOnCone(const Shape& shape, const Vector3& p_W) noexcept {
  const AxialPoint point = axialPoint(shape, p_W);
  const Slant slant(point);
  const SurfacePoint base = onBase(point);
  const SurfacePoint side = onSide(point, slant);
  if (base.distance <= 0 && side.distance <= 0) return base.distance > side.distance ? base : side;
  const double fromApex = point.radial * slant.radial + (point.along - point.halfHeight) * slant.along;
  const double t = std::clamp(fromApex, 0.0, slant.length);
  const SurfacePoint toSide = from(point, t * slant.radial, point.halfHeight + t * slant.along, side);
  const SurfacePoint toBase = from(point, std::min(point.radial, point.radius), -point.halfHeight, base);
  const double difference = toBase.distance - toSide.distance;
  const bool atTheRim = std::abs(difference) <= 1e-12 * std::max(toBase.distance, toSide.distance);
  const bool baseIsNearer = atTheRim ? base.distance > side.distance : difference < 0;
  return baseIsNearer ? toBase : toSide;
}

}  // namespace haptiv
