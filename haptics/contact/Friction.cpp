#include "haptics/contact/Friction.h"

#include <algorithm>

#include "haptics/contact/FreeVelocity.h"
#include "haptics/contact/Proxy.h"

namespace haptiv {
namespace {

/// What presses the proxy on the walls.
struct Cone {
  double depth = 0;         ///< sum of d_i [m]
  double normalForce = 0;   ///< sum of k_i d_i [N]
  double staticForce = 0;   ///< sum of mu_i k_i d_i [N]
  double dynamicForce = 0;  ///< the same [N]

  void press(const SurfaceProperties& surface, double d) noexcept {
    const double force = surface.stiffness * d;
    depth += d;
    normalForce += force;
    staticForce += surface.staticFriction * force;
    dynamicForce += std::min(surface.dynamicFriction, surface.staticFriction) * force;
  }
  double stiffness() const noexcept { return depth > 0 ? normalForce / depth : 0; }
  /// How far the proxy may be from where it would go without friction [m].
  double reach(bool sliding) const noexcept {
    return normalForce > 0 ? (sliding ? dynamicForce : staticForce) / stiffness() : 0;
  }
};

/// Of the contacts of the tick before, for a proxy that is drawn to `goal`.
Cone coneAt(const HapticScene& scene, const ContactSet& before, const Vector3& goal) noexcept {
  ProxyPlanes planes;
  for (const Contact& contact : before) planes.add(contact.normal, contact.offset);
  planes.shareOut(goal);
  Cone cone;
  for (std::size_t i = 0; i < static_cast<std::size_t>(before.count); ++i) {
    const Contact& contact = before.contact[i];
    const double elastic = contact.depth > 0 ? contact.elasticDepth() / contact.depth : 1;
    cone.press(wallOf(scene, contact).surface, elastic * planes.share[i]);
  }
  return cone;
}

}  // namespace

Friction holdProxy(const HapticScene& scene, const ContactSet& before, const ToolMotion& tool) noexcept {
  const bool hasFriction = std::any_of(before.begin(), before.end(), [&](const Contact& contact) {
    return wallOf(scene, contact).surface.staticFriction > 0;
  });
  if (!hasFriction) return {};
  Vector3 offset = before.frictionOffset - freeVelocity(tool.position - before.toolPosition, before);
  if (before.count == 1) offset -= offset.dot(before.contact[0].normal) * before.contact[0].normal;
  const Cone cone = coneAt(scene, before, tool.position + offset);
  const double length = offset.norm();
  if (length <= cone.reach(before.sliding)) return {offset, false};
  const double yielded = before.frictionOffset.norm() - kSlip * tool.radius;
  const double dynamic = cone.reach(true), most = std::min(length, std::max(dynamic, yielded));
  return {offset * (most / length), true, most > dynamic};
}

Vector3 frictionForce(const HapticScene& scene, const Friction& friction, ContactSet& contacts) noexcept {
  Cone cone;
  for (const Contact& contact : contacts) cone.press(wallOf(scene, contact).surface, contact.elasticDepth());
  const double length = friction.offset.norm();
  const double allowed = std::min(length, cone.reach(friction.sliding && !friction.yielding));
  if (!(allowed > 0)) return Vector3::Zero();
  const Vector3 force = friction.offset * (cone.stiffness() * allowed / length);
  for (Contact& contact : contacts) {
    const SurfaceProperties& surface = wallOf(scene, contact).surface;
    contact.force += force * (surface.stiffness * contact.elasticDepth() / cone.normalForce);
  }
  return force;
}

}  // namespace haptiv
