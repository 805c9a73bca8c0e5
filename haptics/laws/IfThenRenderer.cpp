#include "haptics/laws/IfThenRenderer.h"

#include <algorithm>
#include <limits>

#include "haptics/contact/FollowEdit.h"
#include "haptics/contact/Friction.h"
#include "haptics/contact/Hysteresis.h"
#include "haptics/contact/Proxy.h"
#include "haptics/contact/WallsAround.h"

namespace haptiv {
namespace {

constexpr double kSlip = 1.0 / 16;  ///< of the radius, in a tick

const Wall& wallOf(const HapticScene& scene, const Contact& contact) noexcept {
  return scene.walls[static_cast<std::size_t>(contact.wall)];
}

bool isExact(const HapticScene& scene, const Contact& contact) noexcept {
  return wallOf(scene, contact).shape.kind != Shape::Kind::mesh;
}

/// The exact walls of the tick before; triangles are met anew.
void addRemembered(const HapticScene& scene, const ContactSet& before, ProxyPlanes& planes) noexcept {
  for (const Contact& contact : before) {
    if (isExact(scene, contact)) planes.add(contact.normal, contact.offset);
  }
}

/// What holds the proxy back becomes the contacts, each with its share of the depth; but none is felt deeper than the
/// ball is in it: in a gap narrower than the ball the shares have no meaning.
void keepHolding(const HapticScene& scene, const Proxy& proxy, const NearSurfaces& walls, const Vector3& goal,
                 ContactSet& contacts) noexcept {
  contacts.count = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(proxy.planes.count); ++i) {
    if (!(proxy.planes.share[i] > 0) || contacts.count == ContactSet::kMaxContacts) continue;
    const NearSurface& each = i < walls.count ? walls.surface[i] : proxy.touching.surface[i - walls.count];
    Contact& contact = contacts.contact[static_cast<std::size_t>(contacts.count++)];
    contact.wall = each.wall;
    contact.id = wallOf(scene, contact).id;
    contact.face = each.face;
    contact.normal = each.normal;
    contact.offset = proxy.planes.offset[i];
    contact.depth = std::clamp(contact.offset - contact.normal.dot(goal), 0.0, proxy.planes.share[i]);
  }
}

/// Where no mesh is near: the proxy goes with the ball, and stays outside of the walls of the tick before, plane by
/// plane (a round of Hildreth's row-action method, from their shares). That is near enough to find out which walls are
/// around.
void followWalls(const ContactSet& before, const Vector3& goal, Proxy& proxy) noexcept {
  const bool isFree =
      std::none_of(before.begin(), before.end(), [&](const Contact& c) { return c.offset > c.normal.dot(goal); });
  if (isFree && !proxy.isWedged) {
    proxy.position = goal;
    return;
  }
  Vector3 place = proxy.position + goal - before.goal;
  for (const Contact& contact : before) {
    const double next = std::max(0.0, contact.depth + contact.offset - contact.normal.dot(place));
    place += (next - contact.depth) * contact.normal;
  }
  proxy.goTowards(place);
}

/// The proxy goes on from where the walls of the tick before let it come to, now held by the walls that are around
/// there: those that it can meet within its way. Where it is let go and falls farther, it looks farther.
void meetWalls(const HapticScene& scene, MeshNeighbourhood& meshes, const Vector3& goal, double radius, double way,
               bool wasHeld, ContactSet& contacts, NearSurfaces& walls, Proxy& proxy) noexcept {
  const Vector3 start = proxy.position;
  const BallCourse course{goal - contacts.goal, radius};
  const double left = proxy.way;
  for (const double ahead : {std::clamp(way, kSlip * radius, radius), radius}) {
    findWallsAround(scene, start, radius + ahead, course, contacts.boxes, walls);
    if (!wasHeld && walls.count == 0) return;
    proxy.position = start;
    proxy.way = left;
    proxy.planes.count = 0;
    addPlanes(proxy.planes, walls, start, radius);
    slide(scene, meshes, goal, radius, proxy);
    if ((proxy.position - start).squaredNorm() <= ahead * ahead) return;
  }
}

/// Brings the proxy as near to the goal as the walls let it: first held by the exact walls of the tick before, to find
/// out which are around, then by these.
/// @param way  how far the proxy may go while it is held [m]
void touchWalls(const HapticScene& scene, const Vector3& goal, double radius, double way,
                ContactSet& contacts) noexcept {
  Proxy proxy;
  proxy.position = contacts.surfacePosition;
  proxy.way = way;
  proxy.isWedged = contacts.wedged;
  MeshNeighbourhood meshes(scene, proxy.position, goal - contacts.goal, goal, radius, contacts.blocks);
  if (meshes.isEmpty()) {
    followWalls(contacts, goal, proxy);
  } else {
    addRemembered(scene, contacts, proxy.planes);
    slide(scene, meshes, goal, radius, proxy);
  }
  const bool wasHeld = meshes.isEmpty() ? contacts.count > 0
                                        : std::any_of(contacts.begin(), contacts.end(),
                                                      [&](const Contact& c) { return isExact(scene, c); });
  NearSurfaces walls;
  meetWalls(scene, meshes, goal, radius, way, wasHeld, contacts, walls, proxy);
  meshes.lookAhead();
  keepHolding(scene, proxy, walls, goal, contacts);
  contacts.surfacePosition = proxy.position;
  contacts.goal = goal;
}

/// Brings the proxy on, and says whether it has moved.
bool moveOn(const HapticScene& scene, const ToolMotion& tool, double way, ContactSet& contacts) noexcept {
  constexpr double kAtRest = 1e-6;  // of the radius
  const Vector3 before = contacts.surfacePosition;
  touchWalls(scene, tool.position + contacts.frictionOffset, tool.radius, way, contacts);
  return (contacts.surfacePosition - before).norm() > kAtRest * tool.radius;
}

/// Where the scene is new or was edited, the proxy comes to rest in it at once: SceneFade lets the force in slowly. One
/// that would still slip, as the walls leave it no place and push it to and fro, stays where it is: so does the force.
void settle(const HapticScene& scene, const ToolMotion& tool, ContactSet& contacts) noexcept {
  constexpr int kMostRounds = 32;
  if (!contacts.started) contacts.surfacePosition = contacts.goal = contacts.toolPosition = tool.position;
  contacts.started = true;
  contacts.wedged = false;
  contacts.boxes.forget();
  contacts.blocks.forget();
  followEdit(scene, tool.radius, contacts);
  for (int round = 0; round < kMostRounds; ++round) {
    if (!moveOn(scene, tool, std::numeric_limits<double>::max(), contacts)) break;
  }
  ContactSet next = contacts;
  contacts.wedged = moveOn(scene, tool, kSlip * tool.radius, next);
}

/// How far the proxy may go in a tick while it is held: with the ball, on a curved surface farther, and a little more.
double slipWay(const ToolMotion& tool, const ContactSet& contacts) noexcept {
  return 2 * (tool.position - contacts.toolPosition).norm() + (contacts.wedged ? 0 : kSlip * tool.radius);
}

/// How fast the ball moves into each contact: where several see the same motion, each has its share of it.
ProxyPlanes inwardSpeeds(const ContactSet& contacts, const Vector3& velocity) noexcept {
  ProxyPlanes planes;
  for (const Contact& contact : contacts) planes.add(contact.normal, 0);
  planes.shareOut(velocity);
  return planes;
}

/// Eqs. (26), (27) along each normal.
Vector3 wallForces(const HapticScene& scene, const Vector3& velocity, ContactSet& contacts) noexcept {
  const ProxyPlanes inwards = inwardSpeeds(contacts, velocity);
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(contacts.count); ++i) {
    Contact& contact = contacts.contact[i];
    const SurfaceProperties& surface = wallOf(scene, contact).surface;
    const double speed = surface.dampsOutwards ? -contact.normal.dot(velocity) : inwards.share[i];
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
  Friction friction = holdProxy(scene, contacts, tool.position);
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
