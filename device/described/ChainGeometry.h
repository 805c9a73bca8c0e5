#pragma once

#include <vector>

#include "device/types.h"

namespace haptiv {

/// A revolute joint of a chain, and how it is mounted on the joint before it.
struct ChainJoint {
  Pose mount;  ///< of the joint's frame at angle zero, in the frame of the joint before it, or in B
  Vector3 axis = Vector3::UnitZ();  ///< in the joint's own frame; of length one
};

/// An arm as data: its joints from the base outwards, at most kJointCount.
struct ChainGeometry {
  std::vector<ChainJoint> joints;
  Pose end;  ///< X_LC: the wrist centre, in the frame of the last joint
};

}  // namespace haptiv
