#include "haptics/contact/Proxy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/contact/MeshTouch.h"

namespace haptiv {
namespace {

// Surfaces met or left within a tick: a few to arrive well, more where much of the way is left, and no more.
constexpr int kFewPasses = 4, kMostPasses = 16;
constexpr double kArrived = 1e-5, kAlmost = 1e-2;  ///< of the radius: what is left of the way
constexpr double kStride = 1e-3;                   ///< of the radius: a way worth going with what is known

bool holds(const ProxyPlanes& planes) noexcept {
  return std::any_of(planes.share.begin(), planes.share.begin() + planes.count, [](double share) { return share > 0; });
}

bool isNear(const Vector3& a, const Vector3& b, double reach) noexcept {
  return (a - b).squaredNorm() <= reach * reach;
}

/// Part of the radius that may be left of the way of a proxy that is held; one that is not, has to fall on.
double enoughAfter(int passes) noexcept {
  return passes < kFewPasses ? kArrived : passes < kMostPasses ? kAlmost : std::numeric_limits<double>::infinity();
}

/// How far to look ahead at once: along what is already known about the triangles, as most ways end there.
double stride(const MeshNeighbourhood& meshes, const Vector3& from, const Vector3& direction, double length,
              double radius) noexcept {
  const double known = meshes.knownAlong(from, direction, length, radius);
  return known > kStride * radius ? std::min(length, known) : length;
}

/// What is behind the ball, all the way to the target, in the direction in which the goal is held back: it is not met.
/// Of a surface that bulges, this is all of it but for what the ball touches: it goes along its tangent.
OutOfTheWay behind(const Vector3& from, const Vector3& target, const Vector3& goal, double radius) noexcept {
  const Vector3 back = target - goal;
  const double held = back.norm();
  if (!(held > kStride * radius)) return {};
  const Vector3 normal = back / held;
  return {normal, std::min(normal.dot(from), normal.dot(target)) - radius + touchTolerance(target, radius)};
}

/// Held by one triangle alone, the place next to the goal where the ball touches it, if it is outside of the half space
/// there now; else the target. Around an edge or a corner each plane leads only half of the way there.
Vector3 aroundTriangle(const HapticScene& scene, const NearSurface& touched, const Vector3& goal, double radius,
                       const Vector3& from, const Vector3& target) noexcept {
  const MeshTriangle triangle{static_cast<std::uint32_t>(touched.wall), static_cast<std::uint32_t>(touched.face)};
  const Vector3 away = triangle.away(scene, goal);
  const double distance = away.norm();
  if (!(distance < radius)) return target;
  const Vector3 normal = away / distance;
  const Vector3 place = goal + (radius - distance) * normal;
  return normal.dot(from - place) >= 0 ? place : target;
}

/// Without meshes there is nothing to meet on the way.
void slideAlongWalls(const Vector3& goal, Proxy& proxy) noexcept {
  proxy.touching.count = 0;
  const Vector3 target = proxy.planes.nearest(goal, proxy.position);
  if (proxy.isWedged || holds(proxy.planes)) {
    proxy.goTowards(target);
  } else {
    proxy.position = target;
  }
}

}  // namespace

void addPlanes(ProxyPlanes& planes, const NearSurfaces& near, const Vector3& place, double radius) noexcept {
  for (std::size_t i = 0; i < near.count; ++i) {
    const NearSurface& each = near.surface[i];
    planes.add(each.normal, each.normal.dot(place) + radius - each.distance);
  }
}

void slide(const HapticScene& scene, MeshNeighbourhood& meshes, const Vector3& goal, double radius,
           Proxy& proxy) noexcept {
  if (meshes.isEmpty()) return slideAlongWalls(goal, proxy);
  const int walls = proxy.planes.count;
  for (int pass = 0;; ++pass) {
    findTouched(scene, meshes, proxy.position, radius, proxy.touching);
    proxy.planes.count = walls;
    addPlanes(proxy.planes, proxy.touching, proxy.position, radius);
    Vector3 target = proxy.planes.nearest(goal);
    const bool isAlone = walls == 0 && proxy.planes.count == 1 && holds(proxy.planes);
    if (pass > 0 && isAlone && !isNear(target, proxy.position, kArrived * radius))
      target = aroundTriangle(scene, proxy.touching.surface[0], goal, radius, proxy.position, target);
    const Vector3 step = target - proxy.position;
    const double length = step.norm();
    const bool isHeld = holds(proxy.planes);
    const double allowed = isHeld || proxy.isWedged ? std::min(length, proxy.way) : length;
    if (!(allowed > (isHeld ? enoughAfter(pass) * radius : 0)) || pass > kMostPasses) break;
    const Vector3 direction = step / length;
    const double ahead = stride(meshes, proxy.position, direction, allowed, radius);
    const double gone =
        freeLength(meshes, proxy.position, direction, ahead, radius, behind(proxy.position, target, goal, radius));
    proxy.position = gone == length ? target : Vector3(proxy.position + gone * direction);
    if (isHeld || proxy.isWedged) proxy.way -= gone;
    if (!(gone > 0)) break;  // in a corner so sharp that its planes do not settle
  }
}

}  // namespace haptiv
