#pragma once

#include "device/types.h"

class SoDragger;

namespace haptiv {

/// Gives a handle box knobs that can be seen and hit, the same size on all sides whatever the shape's proportions;
/// Coin's own are squashed with the shape and as pale as the walls.
/// @param halfSize  of the shape along its own axes [m]
void dressHandles(SoDragger& dragger, const Vector3& halfSize);

}  // namespace haptiv
