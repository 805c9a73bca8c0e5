#pragma once

#include <array>

#include "device/described/ChainGeometry.h"
#include "device/kinematics/ArmPose.h"

namespace haptiv {

/// Kinematics of any chain of at most kJointCount revolute joints, in one pass from the base to the end.
/// Angles beyond the chain's joints are ignored, and so are their rates: those columns of J are zero.
class SerialChain {
 public:
  /// Throws std::invalid_argument where there are no joints or more than kJointCount, or an axis is no unit vector.
  explicit SerialChain(const ChainGeometry& geometry);

  int jointCount() const noexcept { return count_; }
  /// X_BC at joint angles q [rad]. Realtime-safe: yes.
  Pose forward(const JointVector& q) const noexcept;
  /// X_BC and J_BC: with the joint's axis z_i through o_i, column i is (z_i x (p_C - o_i), z_i).
  /// Realtime-safe: yes.
  ArmPose evaluate(const JointVector& q) const noexcept;
  /// The base, each joint, and the end. Realtime-safe: yes.
  ArmSkeleton skeleton(const JointVector& q) const noexcept;

 private:
  std::array<ChainJoint, kJointCount> joints_;
  int count_;
  Pose end_;
};

}  // namespace haptiv
