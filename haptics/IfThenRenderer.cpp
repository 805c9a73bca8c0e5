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
  const auto found =
      std::find_if(scene.walls.begin(), scene.walls.end(), [&](const Wall& wall) { return wall.id == contact.id; });
  return found == scene.walls.end() ? nullptr : &*found;
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

/// The walls around that place as half spaces for the ball's centre, by rising index; the nearest kMaxContacts of them.
ContactSet wallsAround(const HapticScene& scene, const Vector3& place, double radius) noexcept {
  ContactSet near;
  std::array<double, kMax> distance{};
  const auto farther = [&](std::size_t a, std::size_t b) {
    return distance[a] != distance[b] ? distance[a] > distance[b] : near.contact[a].wall > near.contact[b].wall;
  };
  forEachNear(scene.walls, scene.wallTree, place, 2 * radius, [&](std::size_t wall, const SurfacePoint& surface) {
    const auto index = static_cast<std::int32_t>(wall);
    auto slot = static_cast<std::size_t>(near.count);
    if (near.count == kMax) {
      slot = 0;
      for (std::size_t i = 1; i < kMax; ++i) slot = farther(i, slot) ? i : slot;
      if (distance[slot] < surface.distance) return;
      if (distance[slot] == surface.distance && near.contact[slot].wall < index) return;
    } else {
      ++near.count;
    }
    distance[slot] = surface.distance;
    Contact& contact = near.contact[slot];
    contact.id = scene.walls[wall].id;
    contact.wall = index;
    contact.face = surface.face;
    contact.normal = surface.normal;
    contact.offset = surface.normal.dot(place) + radius - surface.distance;
  });
  std::sort(near.contact.begin(), near.contact.begin() + near.count,
            [](const Contact& a, const Contact& b) { return a.wall < b.wall; });
  return near;
}

/// Keeps the walls that hold the ball back, each with its share of the depth; but none is felt deeper than the ball is
/// in it: in a gap narrower than the ball the shares have no meaning.
void keepTouching(const ToolMotion& tool, ContactSet& contacts) noexcept {
  Planes planes;
  for (int i = 0; i < contacts.count; ++i) {
    const Contact& contact = contacts.contact[static_cast<std::size_t>(i)];
    planes.add(contact.normal, contact.offset);
  }
  contacts.surfacePosition = planes.nearest(tool.position);
  int kept = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(planes.count); ++i) {
    Contact contact = contacts.contact[i];
    if (!(planes.share[i] > 0)) continue;
    const double depth = contact.offset - contact.normal.dot(tool.position);
    contact.depth = std::clamp(depth, 0.0, planes.share[i]);
    contacts.contact[static_cast<std::size_t>(kept++)] = contact;
  }
  contacts.count = kept;
}

/// Eqs. (26), (27) along one normal.
Vector3 wallLaw(const SurfaceProperties& surface, const Contact& contact, const Vector3& velocity) noexcept {
  const double inwards = std::max(0.0, -velocity.dot(contact.normal));
  return (surface.stiffness * contact.depth + surface.damping * inwards) * contact.normal;
}

}  // namespace

Vector3 renderWalls(const HapticScene& scene, const ToolMotion& tool, ContactSet& contacts) noexcept {
  if (contacts.sceneVersion != scene.version) followEdit(scene, tool, contacts);
  contacts = wallsAround(scene, rememberedPlace(tool.position, contacts), tool.radius);
  contacts.sceneVersion = scene.version;
  keepTouching(tool, contacts);
  Vector3 sum = Vector3::Zero();
  for (int i = 0; i < contacts.count; ++i) {
    Contact& contact = contacts.contact[static_cast<std::size_t>(i)];
    const auto wall = static_cast<std::size_t>(contact.wall);
    contact.force = wallLaw(scene.walls[wall].surface, contact, tool.velocity);
    sum += contact.force;
  }
  return sum;
}

}  // namespace haptiv
