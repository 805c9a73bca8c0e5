#pragma once

#include <array>

#include "device/described/DeltaGeometry.h"
#include "device/kinematics/ArmPose.h"

namespace haptiv {

/// Kinematics of a parallel arm of three legs. Joint i is the angle of upper arm i, from the plane of the base towards
/// B's z; the handle never turns: R_BT is the identity, and the angular rows of J are zero. Joints 4 to 10 are not
/// there.
///
/// A leg closes where, from its elbow to its end of the handle, in the leg's own frame,
///   h = (hypot(du, dw) - (d + e))^2 + dv^2 - b^2 = 0
///   (du, dv, dw) = (p_u - r + c - a cos q, p_v - s, p_w - a sin q)          [Stamper, eqs. of the leg's closed loop]
/// The elbow is the outer one of the two that close the leg, as the real arm's stops have it.
class DeltaArm {
 public:
  static constexpr int kLegs = DeltaGeometry::kLegs;

  explicit DeltaArm(const DeltaGeometry& geometry);

  int jointCount() const noexcept { return kLegs; }
  /// X_BT at q [rad], by Newton's method on the three h, at most kMostSteps long. Where no handle joins the legs at
  /// these angles, the nearest to it that was found. Never NaN for finite input. Realtime-safe: yes.
  Pose forward(const JointVector& q) const noexcept;
  /// J = -(dh/dp)^-1 dh/dq; zero where the legs hold the handle no more, singular. Realtime-safe: yes.
  ArmPose evaluate(const JointVector& q) const noexcept;
  /// Whether all three legs reach a place p_BT [m], before the base, and hold the handle there and nowhere else: what
  /// lies beyond a singular pose is not come to. Realtime-safe: yes.
  bool reaches(const Vector3& p_BT) const noexcept;
  /// Closed form. A place out of reach is drawn towards the middle of the workspace until it is in reach.
  /// Realtime-safe: yes.
  JointVector inverse(const Vector3& p_BT) const noexcept;
  /// From the handle's middle to base and back along the legs, in one line. Realtime-safe: yes.
  ArmSkeleton skeleton(const JointVector& q) const noexcept;

 private:
  static constexpr int kMostSteps = 40;

  /// A leg at a place of the handle: h, and what it changes by.
  struct Closure {
    double gap;       ///< h [m^2]
    Vector3 byPlace;  ///< dh/dp, in B [m]
    double byAngle;   ///< dh/dq [m^2/rad]
  };
  struct Leg {
    Vector3 u, v;  ///< in B; w is B's z
  };

  Closure close(const Leg& leg, const Vector3& p_BT, double angle) const noexcept;
  /// All three h at once, and their derivatives by the place as rows.
  Vector3 gaps(const Vector3& p_BT, const JointVector& q, Matrix3& byPlace) const noexcept;
  Vector3 firstGuess(const JointVector& q) const noexcept;
  /// Angle of the upper arm; false: out of the leg's reach.
  bool solve(const Leg& leg, const Vector3& p_BT, double& angle) const noexcept;
  /// Of all of them.
  bool solve(const Vector3& p_BT, JointVector& q) const noexcept;

  DeltaGeometry geometry_;
  std::array<Leg, kLegs> legs_;
  Vector3 middle_;  ///< of the workspace: the handle with the upper arms at middling angles
};

}  // namespace haptiv
