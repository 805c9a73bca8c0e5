#pragma once

#include <cstdint>
#include <vector>

#include "haptics/HapticScene.h"
#include "haptics/IfThenRenderer.h"

namespace haptiv {

/// One wall: a sphere of 0.1 m about the origin as a mesh of at least so many triangles, all of about one size.
HapticScene meshSphere(std::uint32_t triangles);

inline constexpr double kSphereRadius = 0.1;       // [m]
inline constexpr double kSphereToolRadius = 1e-3;  // [m]

/// A path over that sphere for a ball of kSphereToolRadius, tick by tick: it travels, descends, presses in by half
/// its radius, slides a quarter of the way around, and lifts; again and again, elsewhere.
std::vector<ToolMotion> pathOverSphere(int legs);

}  // namespace haptiv
