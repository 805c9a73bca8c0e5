#include "haptics/shapes/ShapeDistance.h"

#include <cmath>
#include <limits>

#include "haptics/meshes/MeshDistance.h"
#include "haptics/shapes/BoxSurface.h"
#include "haptics/shapes/ConeSurface.h"
#include "haptics/shapes/CylinderSurface.h"
#include "haptics/shapes/SphereSurface.h"

namespace haptiv {
namespace {

const SurfacePoint kNowhere{std::numeric_limits<double>::max(), Vector3::UnitZ(), 0};

/// Sizes beyond the square root of the largest double overflow: such a shape is felt nowhere.
SurfacePoint finiteOrFar(const SurfacePoint& point) noexcept {
  if (std::isfinite(point.distance) && point.normal.allFinite()) return point;
  return kNowhere;
}

SurfacePoint nearestOf(const Shape& shape, const Vector3& p_W) noexcept {
  switch (shape.kind) {
    case Shape::Kind::sphere:
      return nearestOnSphere(shape, p_W);
    case Shape::Kind::cylinder:
      return nearestOnCylinder(shape, p_W);
    case Shape::Kind::cone:
      return nearestOnCone(shape, p_W);
    case Shape::Kind::mesh:
      return shape.mesh ? nearestOnMesh(*shape.mesh, p_W) : kNowhere;
    case Shape::Kind::box:
      break;
  }
  return nearestOnBox(shape, p_W);
}

SurfacePoint onFace(const Shape& shape, const Vector3& p_W, int face) noexcept {
  switch (shape.kind) {
    case Shape::Kind::sphere:
      return nearestOnSphere(shape, p_W);
    case Shape::Kind::cylinder:
      return onCylinderFace(shape, p_W, face);
    case Shape::Kind::cone:
      return onConeFace(shape, p_W, face);
    case Shape::Kind::mesh:
      return shape.mesh ? onMeshFace(*shape.mesh, p_W, face) : kNowhere;
    case Shape::Kind::box:
      break;
  }
  return onBoxFace(shape, p_W, face);
}

}  // namespace

SurfacePoint nearestSurface(const Shape& shape, const Vector3& p_W) noexcept {
  return finiteOrFar(nearestOf(shape, p_W));
}

SurfacePoint surfaceOfFace(const Shape& shape, const Vector3& p_W, int face) noexcept {
  return finiteOrFar(onFace(shape, p_W, face));
}

Bounds boundsOf(const Shape& shape) noexcept {
  if (shape.kind == Shape::Kind::mesh && shape.mesh) return shape.mesh->bounds;
  Vector3 half = shape.axes.cwiseAbs().rowwise().sum();
  if (shape.kind == Shape::Kind::sphere) half.setConstant(shape.axes.col(0).norm());
  if (shape.kind == Shape::Kind::cylinder || shape.kind == Shape::Kind::cone) {
    // A disc of radius R about the unit axis n reaches R sqrt(1 - n_i^2) along i: from its two orthogonal columns.
    const Vector3 disc = (shape.axes.col(0).cwiseAbs2() + shape.axes.col(2).cwiseAbs2()).cwiseSqrt();
    half = disc + shape.axes.col(1).cwiseAbs();
  }
  return {shape.centre - half, shape.centre + half};
}

}  // namespace haptiv
