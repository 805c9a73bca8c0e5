#pragma once

#include <variant>

#include "device/described/DeviceDescription.h"
#include "device/kinematics/ArmPose.h"
#include "device/kinematics/DeltaArm.h"
#include "device/kinematics/SerialChain.h"
#include "device/kinematics/Vishard10.h"

namespace haptiv {

/// Kinematics of the arm that a description names: VISHARD10 by its closed forms, any other serial arm by its chain, a
/// parallel one by its legs; behind the wrist centre C in every case the description's tool transform X_CT.
///
/// Joints beyond jointCount() are not there: their angles are ignored and their columns of J are zero.
class ArmKinematics {
 public:
  /// Throws std::invalid_argument where the description's chain is none; a parsed description's never is.
  explicit ArmKinematics(const DeviceDescription& description);

  int jointCount() const noexcept;
  /// The closed forms; null where the arm is another chain. They are those of the wrist centre, without the tool.
  const Vishard10* vishard10() const noexcept { return std::get_if<Vishard10>(&arm_); }
  /// The legs of a parallel arm, without the tool; null where the arm is serial.
  const DeltaArm* delta() const noexcept { return std::get_if<DeltaArm>(&arm_); }

  /// X_BT at joint angles q [rad]. Realtime-safe: yes.
  Pose forward(const JointVector& q) const noexcept;
  /// J_BT at q: maps joint rates to the tool's twist, in B. Realtime-safe: yes.
  Jacobian jacobian(const JointVector& q) const noexcept { return evaluate(q).J_BT; }
  /// Both, for less than the two apart. Realtime-safe: yes.
  ArmPose evaluate(const JointVector& q) const noexcept;

  /// Angles that put the tool at p_BT [m] with the R_BT of `like`: VISHARD10's inverse function, eqs. (21)-(23), where
  /// it reaches, a parallel arm's closed form; else a damped Newton search from there, or from `like`. Where the place is out of reach, the nearest
  /// that was found: compare forward() of it. Never NaN for finite input.
  /// Realtime-safe: no allocation, but up to some hundred steps long; for set-up.
  JointVector inverse(const Vector3& p_BT, const JointVector& like) const noexcept;

  /// Places along the arm for drawing it. Realtime-safe: yes.
  ArmSkeleton skeleton(const JointVector& q) const noexcept;

 private:
  std::variant<Vishard10, SerialChain, DeltaArm> arm_;
  bool hasTool_;
  Pose X_CT_;
};

}  // namespace haptiv
