#include "haptics/contact/Settle.h"

#include <limits>

#include "haptics/contact/FollowEdit.h"
#include "haptics/contact/Proxy.h"
#include "haptics/contact/TouchWalls.h"

namespace haptiv {
namespace {

/// Brings the proxy on, and says whether it has moved.
bool moveOn(const HapticScene& scene, const ToolMotion& tool, double way, ContactSet& contacts) noexcept {
  constexpr double kAtRest = 1e-6;  // of the radius
  const Vector3 before = contacts.surfacePosition;
  touchWalls(scene, tool.position + contacts.frictionOffset, tool.radius, way, contacts);
  return (contacts.surfacePosition - before).norm() > kAtRest * tool.radius;
}

}  // namespace

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

}  // namespace haptiv
