#pragma once

#include "device/described/DeviceDescription.h"
#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// Where a session in this scene starts: the arm as its description stands at home, with the tool at the scene's.
struct SessionStart {
  JointVector angles = JointVector::Zero();  ///< [rad]
  Vector3 wanted = Vector3::Zero();          ///< p_BT of the scene's home [m]
  Vector3 reached = Vector3::Zero();         ///< p_BT at these angles; as near as the arm comes [m]

  bool inReach() const;
};

SessionStart sessionStart(const HapticScene& scene, const DeviceDescription& device);

}  // namespace haptiv
