#include "haptics/laws/IfThenRenderer.h"

#include <algorithm>

#include "haptics/contact/Friction.h"
#include "haptics/contact/Hysteresis.h"
#include "haptics/contact/Proxy.h"
#include "haptics/contact/Settle.h"
#include "haptics/contact/TouchWalls.h"

namespace haptiv {
namespace {

/// How far the proxy may go in a tick while it is held: with the ball, on a curved surface farther, and a little more.
double slipWay(const ToolMotion& tool, const ContactSet& contacts) noexcept {
  return 2 * (tool.position - contacts.toolPosition).norm() + (contacts.wedged ? 0 : kSlip * tool.radius);
}

/// How fast the ball moves into a contact: of a motion that several see, each has the part that it has of the depth.
double inwardSpeed(const Contact& contact, const Vector3& goal, const Vector3& velocity) noexcept {
  if (!(contact.depth > 0)) return 0;
  const double inside = contact.offset - contact.normal.dot(goal);
  return -contact.normal.dot(velocity) * (contact.depth / inside);
}

/// Eqs. (26), (27) along each normal.
Vector3 wallForces(const HapticScene& scene, const Vector3& velocity, ContactSet& contacts) noexcept {
  Vector3 sum = Vector3::Zero();
  for (Contact& contact : contacts) {
    const SurfaceProperties& surface = wallOf(scene, contact).surface;
    const double inwards = inwardSpeed(contact, contacts.goal, velocity);
    const double speed = surface.dampsOutwards ? inwards : std::max(inwards, 0.0);
    const double push = surface.stiffness * contact.elasticDepth() + surface.damping * speed;
    contact.force = std::max(push, 0.0) * contact.normal;
    sum += contact.force;
  }
  return sum;
}

}  // namespace

Vector3 renderWalls(const HapticScene& scene, const ToolMotion& tool, ContactSet& contacts) noexcept {
  if (!contacts.started || contacts.sceneVersion != scene.version) settle(scene, tool, contacts);
  const double way = slipWay(tool, contacts);
  const WallSlacks slacks = slacksOf(scene, contacts);
  Friction friction = holdProxy(scene, contacts, tool);
  const bool isPulled = !friction.offset.isZero(0);
  touchWalls(scene, tool.position + friction.offset, tool.radius, way, contacts);
  if (isPulled && contacts.count == 0) {  // it has lost its hold
    friction = {};
    touchWalls(scene, tool.position, tool.radius, way, contacts);
  }
  contacts.sliding = friction.sliding;
  contacts.wedged = contacts.wedged && !(contacts.count == 0 && contacts.surfacePosition == contacts.goal);
  contacts.toolPosition = tool.position;
  contacts.frictionOffset = friction.offset;
  takeUpSlack(scene, slacks, contacts);
  const Vector3 sum = wallForces(scene, tool.velocity, contacts);
  return isPulled ? Vector3(sum + frictionForce(scene, friction, contacts)) : sum;
}

}  // namespace haptiv
