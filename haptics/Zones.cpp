#include "haptics/Zones.h"

#include <algorithm>

#include "haptics/NearShapes.h"

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

/// The part of the ball's diameter that is inside, 0 to 1.
double immersion(double distance, double radius) noexcept {
  return std::clamp((radius - distance) / (2 * radius), 0.0, 1.0);
}

}  // namespace

Vector3 renderZones(const HapticScene& scene, const ToolMotion& tool, int& inside) noexcept {
  Vector3 sum = Vector3::Zero();
  inside = 0;
  forEachNear(
      scene.zones, scene.zoneIndex, tool.position, tool.radius, [&](std::size_t index, const SurfacePoint& surface) {
        const Zone& zone = scene.zones[index];
        const Vector3 full = zone.kind == Zone::Kind::viscous ? viscousForce(zone, tool) : springForce(zone, tool);
        sum += immersion(surface.distance, tool.radius) * full;
        ++inside;
      });
  return sum;
}

}  // namespace haptiv
