#pragma once

#include <array>

#include "device/types.h"

namespace haptiv {

/// Where the arm holds the tool, and how the joints move it there.
struct ArmPose {
  Pose X_BT;
  Jacobian J_BT;  ///< in B; columns beyond the arm's joints are zero
};

/// Places along the arm for drawing it, in B [m], from the base to the tool.
struct ArmSkeleton {
  std::array<Vector3, kJointCount + 2> at;
  int count = 0;
};

}  // namespace haptiv
