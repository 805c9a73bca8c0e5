#include "haptics/IfThenRenderer.h"

#include <algorithm>

#include "haptics/HalfSpaces.h"
#include "haptics/NearShapes.h"

namespace haptiv {
namespace {

constexpr int kMax = ContactSet::kMaxContacts;
using Planes = HalfSpaces<kMax>;

const Wall* findWall(const HapticScene& scene, const Contact& contact) noexcept {
  const auto hint = static_cast<std::size_t>(contact.wall);
  if (hint < scene.walls.size() && scene.walls[hint].id == contact.id) return &scene.walls[hint];
  const std::size_t found = findShape(scene.walls, scene.wallIndex, contact.id);
  return found < scene.walls.size() ? &scene.walls[found] : nullptr;
}

/// Where the walls of the last tick's contacts are now: an edit may have moved or removed them.
/// A wall that jumped by more than the ball's size has let go of it.
void followEdit(const HapticScene& scene, const ToolMotion& tool, ContactSet& contacts) noexcept {
  int kept = 0;
  for (int i = 0; i < contacts.count; ++i) {
    Contact contact = contacts.contact[static_cast<std::size_t>(i)];
    const Wall* wall = findWall(scene, contact);
    if (wall == nullptr) continue;
    const SurfacePoint was = surfaceOfFace(wall->shape, contacts.surfacePosition, contact.face);
    const double jump = tool.radius - was.distance;
    if (!(std::abs(jump) <= 2 * tool.radius)) continue;
    contact.normal = was.normal;
    contact.offset = was.normal.dot(contacts.surfacePosition) + jump;
    contacts.contact[static_cast<std::size_t>(kept++)] = contact;
  }
  contacts.count = kept;
}

/// The place next to the ball to which the walls of the last tick let it come.
Vector3 rememberedPlace(const Vector3& position, const ContactSet& contacts) noexcept {
  Planes planes;
  for (int i = 0; i < contacts.count; ++i) {
    const Contact& contact = contacts.contact[static_cast<std::size_t>(i)];
    planes.add(contact.normal, contact.offset);
  }
  return planes.nearest(position);
}

/// A wall near the ball, measured from the remembered place.
struct NearWall {
  std::int32_t wall;
  int face;
  double distance;  ///< [m]
  Vector3 normal;
};

/// The nearest kMaxContacts of them, by rising number: the same ones in whatever order they are found.
struct NearWalls {
  std::array<NearWall, kMax> wall;
  std::size_t count = 0;

  void take(const NearWall& found) noexcept {
    if (count == kMax && !makeRoom(found)) return;
    std::size_t at = count++;
    for (; at > 0 && wall[at - 1].wall > found.wall; --at) wall[at] = wall[at - 1];
    wall[at] = found;
  }

 private:
  /// Drops the farthest; of equally far ones, the last.
  bool makeRoom(const NearWall& found) noexcept {
    std::size_t farthest = 0;
    for (std::size_t i = 1; i < count; ++i) {
      if (wall[i].distance >= wall[farthest].distance) farthest = i;
    }
    const double most = wall[farthest].distance;
    if (found.distance > most || (found.distance == most && found.wall > wall[farthest].wall)) return false;
    --count;
    for (std::size_t i = farthest; i < count; ++i) wall[i] = wall[i + 1];
    return true;
  }
};

void findNear(const HapticScene& scene, const Vector3& place, double reach, NearWalls& near) noexcept {
  forEachNear(scene.walls, scene.wallIndex, place, reach, [&](std::size_t wall, const SurfacePoint& surface) {
    near.take({static_cast<std::int32_t>(wall), surface.face, surface.distance, surface.normal});
  });
}

/// The walls around `place` as half spaces for the ball's centre. Those that hold the ball back become its contacts,
/// each with its share of the depth; but none is felt deeper than the ball is in it: in a gap narrower than the ball
/// the shares have no meaning.
void touch(const HapticScene& scene, const NearWalls& near, const Vector3& place, const ToolMotion& tool,
           ContactSet& contacts) noexcept {
  Planes planes;
  for (std::size_t i = 0; i < near.count; ++i) {
    const NearWall& each = near.wall[i];
    planes.add(each.normal, each.normal.dot(place) + tool.radius - each.distance);
  }
  contacts.surfacePosition = planes.nearest(tool.position);
  contacts.count = 0;
  for (std::size_t i = 0; i < near.count; ++i) {
    if (!(planes.share[i] > 0)) continue;
    const NearWall& each = near.wall[i];
    Contact& contact = contacts.contact[static_cast<std::size_t>(contacts.count++)];
    contact.id = scene.walls[static_cast<std::size_t>(each.wall)].id;
    contact.wall = each.wall;
    contact.face = each.face;
    contact.normal = each.normal;
    contact.offset = planes.offset[i];
    contact.depth = std::clamp(contact.offset - contact.normal.dot(tool.position), 0.0, planes.share[i]);
  }
}

/// Eqs. (26), (27) along one normal.
Vector3 wallLaw(const SurfaceProperties& surface, const Contact& contact, const Vector3& velocity) noexcept {
  const double inwards = std::max(0.0, -velocity.dot(contact.normal));
  return (surface.stiffness * contact.depth + surface.damping * inwards) * contact.normal;
}

}  // namespace

Vector3 renderWalls(const HapticScene& scene, const ToolMotion& tool, ContactSet& contacts) noexcept {
  if (contacts.sceneVersion != scene.version) followEdit(scene, tool, contacts);
  contacts.sceneVersion = scene.version;
  const Vector3 place = rememberedPlace(tool.position, contacts);
  NearWalls near;
  findNear(scene, place, 2 * tool.radius, near);
  touch(scene, near, place, tool, contacts);
  Vector3 sum = Vector3::Zero();
  for (int i = 0; i < contacts.count; ++i) {
    Contact& contact = contacts.contact[static_cast<std::size_t>(i)];
    contact.force = wallLaw(scene.walls[static_cast<std::size_t>(contact.wall)].surface, contact, tool.velocity);
    sum += contact.force;
  }
  return sum;
}

}  // namespace haptiv
