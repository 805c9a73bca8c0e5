#include "haptics/contact/Hysteresis.h"

#include <algorithm>

namespace haptiv {
namespace {

double depthInWall(const ContactSet& contacts, ShapeId id) noexcept {
  Vector3 sum = Vector3::Zero();
  for (const Contact& contact : contacts) {
    if (contact.id == id) sum += contact.depth * contact.normal;
  }
  return sum.norm();
}

}  // namespace

WallSlacks slacksOf(const HapticScene& scene, const ContactSet& contacts) noexcept {
  WallSlacks slacks;
  for (const Contact& contact : contacts) {
    if (!(wallOf(scene, contact).surface.hysteresis > 0) || !(contact.depth > 0)) continue;
    const double depth = depthInWall(contacts, contact.id);
    slacks.wall[slacks.count++] = {contact.id, depth, depth * (contact.slack / contact.depth)};
  }
  return slacks;
}

void takeUpSlack(const HapticScene& scene, const WallSlacks& before, ContactSet& now) noexcept {
  for (Contact& contact : now) {
    contact.slack = 0;
    const double most = wallOf(scene, contact).surface.hysteresis;
    const double depth = most > 0 ? depthInWall(now, contact.id) : 0;
    if (!(depth > 0)) continue;
    const auto end = before.wall.begin() + before.count;
    const auto last = std::find_if(before.wall.begin(), end, [&](const auto& wall) { return wall.id == contact.id; });
    const double slack = last == end ? 0 : last->slack - (depth - last->depth);
    contact.slack = contact.depth * (std::clamp(slack, 0.0, std::min(most, depth)) / depth);
  }
}

}  // namespace haptiv
