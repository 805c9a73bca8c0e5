#include "haptics/contact/MeshTouch.h"

#include <algorithm>
#include <cmath>

#include "haptics/contact/FirstTouch.h"
#include "haptics/meshes/MeshDistance.h"
#include "haptics/shapes/AxialPoint.h"

namespace haptiv {
namespace {

constexpr double kTouch = 1e-7;              ///< of the radius. Twice as high over an edge the normal is off by 6.4e-4:
constexpr double kSameNormal = 1e-3;         ///< so these are one
constexpr double kAboutToTouch = 1.0 / 256;  ///< of the radius

/// Takes a touch into the list, or in the place of one of the same normal that is farther.
void takeTouch(NearSurfaces& list, const NearSurface& touch) noexcept {
  std::size_t slot = list.count;
  for (std::size_t i = 0; i < list.count; ++i) {
    const NearSurface& other = list.surface[i];
    if (other.wall != touch.wall) continue;
    if ((other.normal - touch.normal).squaredNorm() > kSameNormal * kSameNormal) continue;
    if (other.distance <= touch.distance) return;
    slot = i;
    break;
  }
  if (slot == NearSurfaces::kMost) return;  // freeLength stops the ball there all the same
  if (slot == list.count) ++list.count;
  list.surface[slot] = touch;
}

}  // namespace

double touchTolerance(const Vector3& p_W, double radius) noexcept {
  return kTouch * radius + 1e-15 * p_W.cwiseAbs().maxCoeff();
}

void findTouched(const HapticScene& scene, MeshNeighbourhood& meshes, const Vector3& p_W, double radius,
                 NearSurfaces& touched) noexcept {
  touched.count = 0;
  const double reach = radius + 2 * touchTolerance(p_W, radius);
  const auto touch = [&](const MeshTriangle& triangle, const Vector3& away) {
    const double distance = away.norm();
    const Vector3 normal = distance > kTouch * radius
                               ? Vector3(away / distance)
                               : faceNormal(*scene.walls[triangle.wall].shape.mesh, triangle.number);
    takeTouch(touched, {static_cast<std::int32_t>(triangle.wall), static_cast<int>(triangle.number), distance, normal});
  };
  meshes.forEachNear(p_W, reach, touch);
  if (touched.count == 0) meshes.nearest(p_W, (1 + kAboutToTouch) * radius, touch);
}

double freeLength(MeshNeighbourhood& meshes, const Vector3& from_W, const Vector3& direction, double length,
                  double radius, const OutOfTheWay& out) noexcept {
  const BallWay way{from_W, direction, length, radius, touchTolerance(from_W, radius)};
  double free = length;
  meshes.forEachAlong(from_W, direction, radius, out, free,
                      [&](double start, auto&& awayOf) { free = wayToTouch(way, start, free, awayOf); });
  return free;
}

}  // namespace haptiv
