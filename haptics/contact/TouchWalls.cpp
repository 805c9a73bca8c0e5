#include "haptics/contact/TouchWalls.h"

#include <algorithm>

#include "haptics/contact/Proxy.h"
#include "haptics/contact/WallsAround.h"

namespace haptiv {
namespace {

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
/// there: those that it can meet within half of its way, which is nearly always enough. Where it goes farther, it looks
/// farther.
void meetWalls(const HapticScene& scene, MeshNeighbourhood& meshes, const Vector3& goal, double radius, double way,
               bool wasHeld, ContactSet& contacts, NearSurfaces& walls, Proxy& proxy) noexcept {
  const Vector3 start = proxy.position;
  const BallCourse course{goal - contacts.goal, radius};
  const double left = proxy.way;
  for (const double ahead : {std::clamp(way / 2, kSlip / 2 * radius, radius), radius}) {
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

}  // namespace

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

}  // namespace haptiv
