#pragma once

#include "device/described/DeviceDescription.h"
#include "device/kinematics/ArmPose.h"

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

  /// X_BT at joint angles q [rad], T in the wrist centre. Realtime-safe: yes.
  Pose forward(const JointVector& q) const noexcept;
  /// J_BT at q: maps joint rates to the tool's twist, in B. Realtime-safe: yes.
  Jacobian jacobian(const JointVector& q) const noexcept;
  /// Both, for the sines of one. Realtime-safe: yes.
  ArmPose evaluate(const JointVector& q) const noexcept;
  /// Inverse function, eqs. (21)-(23): angles 1..7 that put the wrist centre at p_BT [m]. The heading th5*, the tilt
  /// th8* and angles 9 and 10 are those of `like`, and so is R_BT.
  /// |x|, |y| <= 2 l1 and |z| <= 2 l6 are in reach; others are clamped to it. Realtime-safe: yes.
  JointVector inverse(const Vector3& p_BT, const JointVector& like) const noexcept;
  /// Ten places along the arm for drawing it, in B: joints 1..5 in the SCARA plane, the column's head at the end of
  /// l5h, the column's foot, which is joint 6, joints 7 and 8, the wrist centre. Realtime-safe: yes.
  ArmSkeleton skeleton(const JointVector& q) const noexcept;

 private:
  LinkLengths links_;
};

}  // namespace haptiv
