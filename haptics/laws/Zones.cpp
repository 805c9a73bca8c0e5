#include "haptics/laws/Zones.h"

#include <algorithm>

#include "haptics/scene/NearShapes.h"

namespace haptiv {
namespace {

Vector3 viscousForce(const Zone& zone, const ToolMotion& tool) noexcept {
  return -zone.damping * tool.velocity;
}

Vector3 springForce(const Zone& zone, const ToolMotion& tool) noexcept {
  const Vector3 toAnchor = zone.anchor - tool.position;
  const double length = toAnchor.norm();
  if (zone.restLength == 0) return zone.stiffness * toAnchor;  // smooth through the anchor
  if (!(length > 0)) return Vector3::Zero();                   // no direction is better than another
  return zone.stiffness * (1 - zone.restLength / length) * toAnchor;
}

Vector3 rubberBandForce(const Zone& zone, const ToolMotion& tool) noexcept {
  const bool isSlack = (zone.anchor - tool.position).norm() <= zone.restLength;
  return isSlack ? Vector3(Vector3::Zero()) : springForce(zone, tool);
}

Vector3 zoneForce(const Zone& zone, const ToolMotion& tool) noexcept {
  switch (zone.kind) {
    case Zone::Kind::viscous:
      return viscousForce(zone, tool);
    case Zone::Kind::rubberBand:
      return rubberBandForce(zone, tool);
    case Zone::Kind::spring:
      break;
  }
  return springForce(zone, tool);
}

/// An open mesh has no inside.
bool hasInside(const Shape& shape) noexcept {
  return shape.kind != Shape::Kind::mesh || (shape.mesh && shape.mesh->closed);
}

/// The part of the ball's diameter that is inside, 0 to 1.
double immersion(double distance, double radius) noexcept {
  return std::clamp((radius - distance) / (2 * radius), 0.0, 1.0);
}

}  // namespace

Vector3 renderZones(const HapticScene& scene, const ToolMotion& tool, int& inside) noexcept {
  Vector3 sum = Vector3::Zero();
  inside = 0;
  forEachNear(scene.zones, scene.zoneIndex, tool.position, tool.radius, hasInside,
              [&](std::size_t index, const SurfacePoint& surface) {
                sum += immersion(surface.distance, tool.radius) * zoneForce(scene.zones[index], tool);
                ++inside;
              });
  return sum;
}

}  // namespace haptiv
