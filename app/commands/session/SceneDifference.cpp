#include "app/commands/session/SceneDifference.h"

#include <vector>

namespace haptiv {
namespace {

template <typename T>
void carry(T& to, const T& before, const T& after) {
  if (before != after) to = after;
}

bool isSame(const TriangleMesh* a, const TriangleMesh* b) {
  return a == b || (a && b && a->vertices == b->vertices && a->triangles == b->triangles);
}

void carry(Shape& to, const Shape& before, const Shape& after) {
  if (!isSame(before.mesh.get(), after.mesh.get())) to.mesh = after.mesh;
  carry(to.kind, before.kind, after.kind);
  carry(to.centre, before.centre, after.centre);
  carry(to.axes, before.axes, after.axes);
}

void carry(Wall& to, const Wall& before, const Wall& after) {
  carry(to.shape, before.shape, after.shape);
  carry(to.surface.stiffness, before.surface.stiffness, after.surface.stiffness);
  carry(to.surface.damping, before.surface.damping, after.surface.damping);
  carry(to.surface.hysteresis, before.surface.hysteresis, after.surface.hysteresis);
  carry(to.surface.staticFriction, before.surface.staticFriction, after.surface.staticFriction);
  carry(to.surface.dynamicFriction, before.surface.dynamicFriction, after.surface.dynamicFriction);
}

void carry(Zone& to, const Zone& before, const Zone& after) {
  carry(to.kind, before.kind, after.kind);
  carry(to.shape, before.shape, after.shape);
  carry(to.damping, before.damping, after.damping);
  carry(to.stiffness, before.stiffness, after.stiffness);
  carry(to.restLength, before.restLength, after.restLength);
  carry(to.anchor, before.anchor, after.anchor);
}

// All shapes are taken anew where their number is another: one was switched on or off.
template <typename T>
void carry(std::vector<T>& to, const std::vector<T>& before, const std::vector<T>& after) {
  if (to.size() != before.size() || before.size() != after.size()) {
    to = after;
    return;
  }
  for (std::size_t i = 0; i < to.size(); ++i) carry(to[i], before[i], after[i]);
}

}  // namespace

void carryDifference(HapticScene& to, const HapticScene& before, const HapticScene& after) {
  carry(to.tool.mass, before.tool.mass, after.tool.mass);
  carry(to.tool.damping, before.tool.damping, after.tool.damping);
  carry(to.tool.radius, before.tool.radius, after.tool.radius);
  carry(to.walls, before.walls, after.walls);
  carry(to.zones, before.zones, after.zones);
  computeBounds(to);
}

}  // namespace haptiv
