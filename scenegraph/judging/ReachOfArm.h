#pragma once

#include "device/described/DeviceDescription.h"
#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// Around all places to which an arm could ever bring its tool: an upright cylinder about the origin of B [m].
struct ReachOfArm {
  double radius = 0;
  double halfHeight = 0;

  static ReachOfArm of(const DeviceDescription& device);

  /// The nearest place within it, in B.
  Vector3 nearest(const Vector3& p_B) const;
  /// How far a shape that stands in the scene is out of it, in scene metres; 0: it is not.
  double distanceTo(const Shape& shape, const DevicePlacement& placed) const;
};

}  // namespace haptiv
