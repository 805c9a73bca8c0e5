#pragma once

#include "device/types.h"

namespace haptiv {

/// Axis-aligned box in W [m].
struct Bounds {
  Vector3 low = Vector3::Zero();
  Vector3 high = Vector3::Zero();
};

}  // namespace haptiv
