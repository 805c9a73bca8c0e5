#include "haptics/contact/FollowEdit.h"

#include <cmath>

#include "haptics/contact/Proxy.h"
#include "haptics/scene/NearShapes.h"

namespace haptiv {
namespace {

const Wall* findWall(const HapticScene& scene, const Contact& contact) noexcept {
  const auto hint = static_cast<std::size_t>(contact.wall);
  if (hint < scene.walls.size() && scene.walls[hint].id == contact.id) return &scene.walls[hint];
  const std::size_t found = findShape(scene.walls, scene.wallIndex, contact.id);
  return found < scene.walls.size() ? &scene.walls[found] : nullptr;
}

/// The touched face as it is now, seen from the side on which it was touched.
SurfacePoint faceNow(const Wall& wall, const Contact& contact, const Vector3& place) noexcept {
  SurfacePoint face = surfaceOfFace(wall.shape, place, contact.face);
  if (wall.shape.kind == Shape::Kind::mesh && face.normal.dot(contact.normal) < 0) {
    face.distance = -face.distance;  // it came past the ball's centre
    face.normal = -face.normal;
  }
  return face;
}

}  // namespace

Vector3 outsideMeshes(const HapticScene& scene, const Vector3& p_W, double radius) noexcept {
  Vector3 place = p_W;
  const auto isSolidMesh = [](const Shape& shape) {
    return shape.kind == Shape::Kind::mesh && shape.mesh && shape.mesh->closed;
  };
  forEachNear(scene.walls, scene.wallIndex, p_W, 0, isSolidMesh,
              [&](std::size_t, const SurfacePoint& surface) { place += (radius - surface.distance) * surface.normal; });
  return place;
}

void followEdit(const HapticScene& scene, double radius, ContactSet& contacts) noexcept {
  const Vector3 place = contacts.surfacePosition;
  ProxyPlanes planes;
  int kept = 0;
  for (Contact contact : contacts) {
    const Wall* wall = findWall(scene, contact);
    if (wall == nullptr) continue;
    const SurfacePoint face = faceNow(*wall, contact, place);
    const double jump = radius - face.distance;
    if (!(std::abs(jump) <= 2 * radius)) continue;
    contact.wall = static_cast<std::int32_t>(wall - scene.walls.data());
    contact.normal = face.normal;
    contact.offset = face.normal.dot(place) + jump;
    planes.add(contact.normal, contact.offset);
    contacts.contact[static_cast<std::size_t>(kept++)] = contact;
  }
  contacts.count = kept;
  contacts.surfacePosition = outsideMeshes(scene, planes.nearest(place), radius);
  contacts.sceneVersion = scene.version;
}

}  // namespace haptiv
