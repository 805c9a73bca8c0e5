#include "device/redundancy/PartitionedSolution.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "device/redundancy/criterion/CriterionGradient.h"

namespace haptiv {
namespace {

constexpr double kLeanGain = 2;    // [1/s]
constexpr double kLeanRate = 0.5;  // [rad/s]

/// The tool's place behind the wrist centre, in B, from J alone: joints 9 and 10 turn about the wrist centre, and
/// their axes are perpendicular. With v_i = w_i x r, v_9 x w_9 is r without its part along w_9, which v_10 x w_10 has.
Vector3 toolBehindWrist(const Jacobian& J) noexcept {
  const Vector3 w9 = J.col(8).tail<3>(), w10 = J.col(9).tail<3>();
  const Vector3 v9 = J.col(8).head<3>(), v10 = J.col(9).head<3>();
  return v9.cross(w9) + w9.dot(v10.cross(w10)) * w9;
}

/// A lower bound of the smallest singular value, near it where the others are alike, from w and the Gram matrix's
/// trace: the product of the others is largest where they are equal.
template <int Rows, int Cols>
double smallestSigma(const PseudoInverse<Rows, Cols>& inverse) noexcept {
  const double trace = inverse.gram().trace();
  if (!(trace > 0)) return 0;
  return inverse.manipulability() * (Rows == 3 ? 2 / trace : Rows == 2 ? 1 / std::sqrt(trace) : 1);
}

/// The damping itself sees to it that rates have no step: at 2 `largest` it is zero.
template <int Rows, int Cols>
void damp(PseudoInverse<Rows, Cols>& inverse, double largest) noexcept {
  inverse.damp(largest, smallestSigma(inverse) < 2 * largest ? 1 : 0);
}

}  // namespace

/// J taken apart.
struct PartitionedSolution::Columns {
  explicit Columns(const Jacobian& J) noexcept : p_CT(toolBehindWrist(J)) {
    Eigen::Matrix<double, 3, 7> v;  // of the wrist centre
    for (int i = 0; i < 7; ++i) v.col(i) = J.col(i).head<3>() - J.col(i).tail<3>().cross(p_CT);
    for (int i = 0; i < 4; ++i) xy.col(i) = (v.col(i) - v.col(4)).head<2>();  // th5* stands still
    const Vector3 lean = v.col(5), halfAngle = 2 * v.col(6) - v.col(5);       // th6 = a - h, th7 = 2 h
    z << lean.z(), halfAngle.z();
    moved << v.col(4).head<2>(), lean.head<2>(), halfAngle.head<2>();
    rotation << J.col(4).tail<3>(), J.col(5).tail<3>(), J.col(8).tail<3>(), J.col(9).tail<3>();
  }
  Vector3 p_CT;
  Eigen::Matrix<double, 2, 4> xy;
  Eigen::Matrix<double, 1, 2> z;
  Eigen::Matrix<double, 2, 3> moved;
  Eigen::Matrix<double, 3, 4> rotation;
};

PartitionedSolution::PartitionedSolution(const JointVector& q, const Jacobian& J, const JointVector& squaredWeights,
                                         const ControlSettings& control) noexcept
    : PartitionedSolution(q, Columns(J), squaredWeights, control) {}

PartitionedSolution::PartitionedSolution(const JointVector& q, const Columns& columns,
                                         const JointVector& squaredWeights, const ControlSettings& control) noexcept
    : lean_(std::remainder(q[5] + q[6] / 2, std::numbers::pi)),
      p_CT_(columns.p_CT),
      moved_(columns.moved),
      J_xy_(columns.xy),
      J_rot_(columns.rotation),
      squaredWeights_xy_(squaredWeights.head<4>()),
      squaredWeights_rot_(squaredWeights[4], squaredWeights[7], squaredWeights[8], squaredWeights[9]),
      planar_(J_xy_, squaredWeights_xy_),
      rotational_(J_rot_, squaredWeights_rot_),
      vertical_(columns.z, Vector2::Ones()) {
  damp(planar_, control.singularityDamping);
  damp(rotational_, control.singularityDamping);
  damp(vertical_, control.singularityDamping);
}

JointVector PartitionedSolution::assemble(const Vector4& orientation, const Vector2& lift, const Vector2& v_xy,
                                          const Vector4& scara) const noexcept {
  const Vector3 others(orientation[0], lift[0], lift[1]);
  JointVector rates;
  rates.head<4>() = planar_.leastNorm(v_xy - moved_ * others) + scara;
  rates[4] = orientation[0] - rates.head<4>().sum();
  rates[5] = lift[0] - lift[1];
  rates[6] = 2 * lift[1];
  rates[7] = orientation[1] - lift.sum();
  rates.tail<2>() = orientation.tail<2>();
  return rates;
}

JointVector PartitionedSolution::leastNorm(const Vector6& twist) const noexcept {
  const Vector3 angular = twist.tail<3>();
  const Vector3 linear = twist.head<3>() - angular.cross(p_CT_);
  const Vector2 lift = vertical_.leastNorm(linear.tail<1>());
  return assemble(rotational_.leastNorm(angular), lift, linear.head<2>(), Vector4::Zero());
}

JointVector PartitionedSolution::upkeep() const noexcept {
  const double back = std::clamp(-kLeanGain * lean_, -kLeanRate, kLeanRate);
  return assemble(Vector4::Zero(), vertical_.nullSpacePart({back, 0}), Vector2::Zero(), Vector4::Zero());
}

CriterionPair PartitionedSolution::values(Strategy strategy) const noexcept {
  return {criterionValue<2>(strategy, BlockEigen<2>(planar_.gram()).sigma, Corners::sharp),
          criterionValue<3>(strategy, BlockEigen<3>(rotational_.gram()).sigma, Corners::sharp)};
}

JointVector PartitionedSolution::selfMotion(Strategy strategy, const CriterionPair& weights) const noexcept {
  const BlockEigen<2> planar(planar_.gram());
  const BlockEigen<3> rotational(rotational_.gram());
  const Vector4 xy = planarGradient(strategy, J_xy_, squaredWeights_xy_, planar, Corners::rounded);
  const Vector4 rot = wristGradient(strategy, J_rot_, squaredWeights_rot_, rotational, Corners::rounded);
  return assemble(rotational_.nullSpacePart(weights.rotation * rot), Vector2::Zero(), Vector2::Zero(),
                  planar_.nullSpacePart(weights.translation * xy));
}

}  // namespace haptiv
