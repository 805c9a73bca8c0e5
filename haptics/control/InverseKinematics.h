#pragma once

#include "device/DeviceDescription.h"
#include "device/kinematics/ArmKinematics.h"
#include "device/redundancy/RedundancyResolution.h"
#include "haptics/control/ResolutionBlend.h"

namespace haptiv {

/// The box "inverse kinematics" of fig. 6: from the motion wanted of the tool to the joints' rates.
///
/// Redundancy resolution (3)-(5), (24), (25), closed by drift correction. Where a joint would turn faster than its
/// limit, the whole motion slows down, so that the tool keeps its direction.
class InverseKinematics {
 public:
  InverseKinematics(const DeviceDescription& description, double period);

  struct Motion {
    JointVector rates = JointVector::Zero();  ///< within the rate limits [rad/s]
    double share = 1;                         ///< of the wanted motion that they are, 0 to 1
  };

  /// @param wanted  X_BT where the tool is to be now
  /// @param twist   its wanted velocity, in B
  /// @param q       desired joint angles now [rad]
  /// Realtime-safe: yes.
  Motion operator()(const ResolutionChoice& choice, const Pose& wanted, const Vector6& twist, const JointVector& q,
                    ResolutionBlend& blend) const noexcept;

 private:
  ArmKinematics arm_;
  RedundancyResolution resolution_;
  JointVector rateLimit_;
  double driftGain_;
  double period_;
};

}  // namespace haptiv
