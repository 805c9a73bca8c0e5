#pragma once

#include <cstdint>
#include <vector>

#include "haptics/laws/IfThenRenderer.h"
#include "haptics/scene/HapticScene.h"

namespace haptiv {

inline constexpr double kSphereRadius = 0.1;       // [m], at scale 1
inline constexpr double kSphereToolRadius = 1e-3;  // [m], at scale 1

/// One wall: a sphere about the origin as a mesh of at least so many triangles, all of about one size.
HapticScene meshSphere(std::uint32_t triangles, double scale = 1);

/// A path over that sphere, tick by tick: the ball travels, descends, presses in by half its radius, slides a quarter
/// of the way around, and lifts; again and again, elsewhere.
std::vector<ToolMotion> pathOverSphere(int legs, double scale = 1);

}  // namespace haptiv
