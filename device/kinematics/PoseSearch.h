#pragma once

#include "device/types.h"

namespace haptiv {

class ArmKinematics;

/// Joint angles that hold the tool at X_BT, by damped Newton steps from `start`, a bounded number of them: for set-up.
/// Where the pose is out of reach, or the search is caught, the nearest place found. Never NaN for finite input.
JointVector searchPose(const ArmKinematics& arm, const Pose& X_BT, const JointVector& start) noexcept;

}  // namespace haptiv
