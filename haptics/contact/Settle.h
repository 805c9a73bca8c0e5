#pragma once

#include "haptics/contact/ContactSet.h"

namespace haptiv {

/// Where the scene is new or was edited, the proxy comes to rest in it at once: SceneFade lets the force in slowly. One
/// that would still slip, as the walls leave it no place and push it to and fro, stays where it is: so does the force.
/// Realtime-safe: yes.
void settle(const HapticScene& scene, const ToolMotion& tool, ContactSet& contacts) noexcept;

}  // namespace haptiv
