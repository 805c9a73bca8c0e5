#pragma once

#include "app/session/hands/SpaceMouseChoice.h"
#include "device/kinematics/ArmKinematics.h"
#include "device/usb/spacemouse/SpaceMouse.h"
#include "haptics/scene/HapticScene.h"
#include "haptics/tick/TickRecord.h"

namespace haptiv {

/// An operator at a SpaceMouse that is plugged in, for a live session's hand. Thread: that of the session.
class SpaceMouseOperator {
 public:
  /// Opens the SpaceMouse. Throws std::runtime_error: what is wrong, and what to do.
  SpaceMouseOperator(const SpaceMouseChoice& choice, const DeviceDescription& description,
                     const DevicePlacement& placement);

  /// What the operator wants now; to be asked some 60 times a second or more.
  /// @param newest   tick of the session
  /// @param heading  as SpaceMouseHand has it [rad]
  SpaceMouseHand::Wish wish(const TickRecord& newest, double heading = 0);

 private:
  ArmKinematics arm_;
  Matrix3 R_WB_;
  SpaceMouseHand hand_;
  SpaceMouse mouse_;
};

}  // namespace haptiv
