#pragma once

#include "device/described/DeviceDescription.h"
#include "device/kinematics/ArmKinematics.h"
#include "device/redundancy/RedundancyResolution.h"
#include "haptics/control/ReachLimit.h"
#include "haptics/control/ResolutionBlend.h"

namespace haptiv {

/// The box "inverse kinematics" of fig. 6: from the motion wanted of the tool to the joints' rates.
///
/// Redundancy resolution (3)-(5), (24), (25), closed by drift correction. On the way out of its reach the tool is
/// slowed down. Where a joint would turn faster than its limit, the whole motion slows down, so that the tool keeps its
/// direction. Where for all that the arm cannot follow, as at an inner singularity, the tool that is wanted is held
/// back to kLeash before the one that is there.
class InverseKinematics {
 public:
  static constexpr double kLeash = 1e-3;  ///< [m]

  InverseKinematics(const DeviceDescription& description, double period);

  struct Motion {
    JointVector rates = JointVector::Zero();  ///< within the rate limits [rad/s]
    double share = 1;                         ///< of the wanted motion that they are, 0 to 1
    Vector3 velocity = Vector3::Zero();       ///< of the tool that is left of the wanted one, in B [m/s]
    Vector3 heldBack = Vector3::Zero();       ///< by which the wanted place is to be taken back, in B [m]
  };

  /// The joints where they are desired now, and how they turned in the tick before.
  struct Joints {
    const JointVector& angles;  ///< [rad]
    const JointVector& rates;   ///< [rad/s]
  };

  /// @param wanted  X_BT where the tool is to be now
  /// @param twist   its wanted velocity, in B
  /// Realtime-safe: yes.
  Motion operator()(const ResolutionChoice& choice, const Pose& wanted, const Vector6& twist, const Joints& joints,
                    ResolutionBlend& blend) const noexcept;

 private:
  ArmKinematics arm_;
  RedundancyResolution resolution_;
  ReachLimit reach_;
  JointVector rateLimit_;
  double driftGain_;
  double period_;
};

}  // namespace haptiv
