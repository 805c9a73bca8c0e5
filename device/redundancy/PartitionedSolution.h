#pragma once

#include "device/control/ResolutionChoice.h"
#include "device/redundancy/criterion/CriterionPair.h"
#include "device/redundancy/matrices/PseudoInverse.h"

namespace haptiv {

/// VISHARD10's position and orientation apart, eqs. (23)-(25): at one pose of the arm.
///
///   orientation  th5*, th8*, th9, th10, by the 3x4 J_rot                                  [paper, eq. (25)]
///   height       joints 6 and 7 as a prismatic joint, th7 = -2 th6                        [paper, eq. (23)]
///   x, y         joints 1 to 4, by the 2x4 J_xy, each block with its own criterion        [paper, eq. (24)]
/// where th5* = th1+..+th5 and th8* = th6+th7+th8.
///
/// Beyond the paper: the arm may start, or be handed over by the full solution, with th7 != -2 th6. With the lean
/// a = th6 + th7/2 of links 6 and 7 and their half angle h = th7/2, zdot = dz/da adot + dz/dh hdot: height by least
/// norm, and the lean goes back to zero within its null space, at most at 0.5 rad/s. Joints 1 to 4 take out what all
/// that does to x and y, so the tool moves as wanted in any pose; at zero lean the solution is the paper's.
///
/// Each block is damped where its smallest singular value is below 2 control.singularityDamping: so is the height,
/// where links 6 and 7 are stretched.
/// Realtime-safe: yes.  Never NaN for finite input.
class PartitionedSolution {
 public:
  /// @param J               J_BT at q of a VISHARD10, with any tool
  /// @param squaredWeights  c_k^2 of the joints, eqs. (7), (8)
  PartitionedSolution(const JointVector& q, const Jacobian& J, const JointVector& squaredWeights,
                      const ControlSettings& control) noexcept;

  /// Rates for a twist of the tool, in B.
  JointVector leastNorm(const Vector6& twist) const noexcept;
  /// Rates that bring th7 back to -2 th6 and leave the tool where it is.
  JointVector upkeep() const noexcept;
  /// Values of a criterion, for J_xy and J_rot.
  CriterionPair values(Strategy strategy) const noexcept;
  /// N_xy grad H_xy with H_xy = w.translation C(J_xy), N_rot grad H_rot with H_rot = w.rotation C(J_rot).
  JointVector selfMotion(Strategy strategy, const CriterionPair& weights) const noexcept;

 private:
  using Vector2 = Eigen::Vector2d;
  using Vector4 = Eigen::Vector4d;
  struct Columns;
  PartitionedSolution(const JointVector& q, const Columns& columns, const JointVector& squaredWeights,
                      const ControlSettings& control) noexcept;

  /// Rates of all joints, such that the wrist moves at v_xy in x and y.
  /// @param orientation  rates of th5*, th8*, th9, th10
  /// @param lift         rates of lean and half angle
  /// @param scara        additional rates of joints 1 to 4 that leave x and y alone
  JointVector assemble(const Vector4& orientation, const Vector2& lift, const Vector2& v_xy,
                       const Vector4& scara) const noexcept;

  double lean_;                        ///< a, in (-pi/2, pi/2] [rad]
  Vector3 p_CT_;                       ///< from the wrist centre to the tool, in B [m]
  Eigen::Matrix<double, 2, 3> moved_;  ///< what th5*, lean and half angle do to x and y
  Eigen::Matrix<double, 2, 4> J_xy_;
  Eigen::Matrix<double, 3, 4> J_rot_;
  Vector4 squaredWeights_xy_, squaredWeights_rot_;
  PseudoInverse<2, 4> planar_;
  PseudoInverse<3, 4> rotational_;
  PseudoInverse<1, 2> vertical_;
};

}  // namespace haptiv
