#pragma once

#include "device/described/DeviceDescription.h"
#include "device/kinematics/ArmKinematics.h"

namespace haptiv {

/// Slows the tool down on its way out of the arm's reach, so that it stops softly at the border.
///
/// How far the border is, the Jacobian J of the tool's place tells: of all ways the one that costs the joints most, in
/// the velocity v that is wanted, is n ~ (J J^T)^-1 v, and per unit of joint rate the tool comes forward along it by
///   m = 1 / sqrt(n^T (J J^T)^-1 n)
/// which is zero at the border. On the way outwards it may fall by no more than
///   m' >= -kRate (m - stop) / (1 - m / near)
/// so that joints and tool come to rest exponentially, in a pose that is still a regular one. stop and near are kStop
/// and kNear of the least m that there is at the arm's home. Only the part of v along n is limited: along the border
/// and back nothing holds the tool.
class ReachLimit {
 public:
  static constexpr double kRate = 5;    ///< [1/s]
  static constexpr double kStop = 0.2;  ///< a few mm before VISHARD10's border
  static constexpr double kNear = 2;

  explicit ReachLimit(const DeviceDescription& description);

  /// @param q         [rad]
  /// @param arm       at q
  /// @param velocity  wanted of the tool, in B [m/s]
  /// @return          the same without what is too fast outwards
  /// Realtime-safe: yes.
  Vector3 operator()(const JointVector& q, const ArmPose& arm, const Vector3& velocity) const noexcept;

 private:
  ArmKinematics arm_;
  double stop_, near_;  ///< of m [m]
};

}  // namespace haptiv
