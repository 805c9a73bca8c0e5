#pragma once

#include <array>

#include "device/DeviceDescription.h"
#include "device/types.h"

namespace haptiv {

/// Kinematics of VISHARD10 in closed form. At zero angles the arm is stretched along x_B and R_BT is the identity.
///
/// With fi = th1+..+thi and th8* = th6+th7+th8:
///   x, y   l1 sum_{i=1..4} (cos fi, sin fi) + (l6 sin th6 + l7 sin(th6+th7)) (sin f5, -cos f5)
///   z      l6 cos th6 + l7 cos(th6+th7)
///   R_BT   Rz(f5) Rx(th8*) Rz(th9) Rx(th10)                                      [paper, Table I, eqs. (21)-(25)]
/// Links 5 and 8 cancel: both lie along the axis about which joints 6, 7 and 8 turn.
class Vishard10 {
 public:
  explicit Vishard10(const LinkLengths& links) : links_(links) {}

  /// X_BT at joint angles q [rad]. Realtime-safe: yes.
  Pose forward(const JointVector& q) const noexcept;
  /// J_BT at q. Realtime-safe: yes.
  Jacobian jacobian(const JointVector& q) const noexcept;
  /// Inverse function, eqs. (21)-(23): angles 1..7 that put the wrist centre at p_BT [m]; angles 8, 9, 10 and the
  /// tool's heading th5* are taken from `like`, so that R_BT stays that of `like`.
  /// |x|, |y| <= 2 l1 and |z| <= 2 l6 are in reach; others are clamped to it.
  JointVector inverse(const Vector3& p_BT, const JointVector& like) const noexcept;
  /// Places along the arm for drawing it, in B: base, joints 2..5, the column's foot, joints 6..8, wrist centre.
  std::array<Vector3, 10> skeleton(const JointVector& q) const noexcept;

 private:
  LinkLengths links_;
};

}  // namespace haptiv
