#include "device/kinematics/ArmKinematics.h"

#include <Eigen/Geometry>

#include "device/kinematics/PoseSearch.h"

namespace haptiv {
namespace {

constexpr double kReached = 1e-9;  // [m]; the closed form is exact but for rounding, or clamps by far more

using AnyArm = std::variant<Vishard10, SerialChain, DeltaArm>;

AnyArm armOf(const DeviceDescription& description) {
  if (description.delta) return DeltaArm(*description.delta);
  if (description.chain.joints.empty()) return Vishard10(description.links);
  return SerialChain(description.chain);
}

}  // namespace

ArmKinematics::ArmKinematics(const DeviceDescription& description)
    : arm_(armOf(description)),
      hasTool_(!description.tool.position.isZero(0) || description.tool.rotation != Matrix3::Identity()),
      X_CT_(description.tool) {}

int ArmKinematics::jointCount() const noexcept {
  if (const auto* chain = std::get_if<SerialChain>(&arm_)) return chain->jointCount();
  return delta() ? delta()->jointCount() : kJointCount;
}

Pose ArmKinematics::forward(const JointVector& q) const noexcept {
  const Pose X_BC = std::visit([&](const auto& arm) { return arm.forward(q); }, arm_);
  if (!hasTool_) return X_BC;
  return {X_BC.position + X_BC.rotation * X_CT_.position, X_BC.rotation * X_CT_.rotation};
}

ArmPose ArmKinematics::evaluate(const JointVector& q) const noexcept {
  ArmPose arm = std::visit([&](const auto& any) { return any.evaluate(q); }, arm_);
  if (!hasTool_) return arm;
  const Vector3 p_CT_B = arm.X_BT.rotation * X_CT_.position;
  arm.X_BT.position += p_CT_B;
  arm.X_BT.rotation = arm.X_BT.rotation * X_CT_.rotation;
  for (int i = 0; i < kJointCount; ++i) {
    const Vector3 axis = arm.J_BT.col(i).tail<3>();
    arm.J_BT.col(i).head<3>() += axis.cross(p_CT_B);
  }
  return arm;
}

JointVector ArmKinematics::inverse(const Vector3& p_BT, const JointVector& like) const noexcept {
  if (const DeltaArm* legs = delta()) return legs->inverse(p_BT - X_CT_.position);  // C never turns
  const Pose wanted{p_BT, forward(like).rotation};
  JointVector start = like;
  if (const Vishard10* closed = vishard10()) {
    const Vector3 p_CT_B = closed->forward(like).rotation * X_CT_.position;
    start = closed->inverse(p_BT - p_CT_B, like);
    if ((forward(start).position - p_BT).norm() <= kReached) return start;
  }
  const JointVector near = searchPose(*this, wanted, start);
  // An arm that lies stretched cannot bend by itself: the search from there is caught.
  const double miss = (forward(near).position - p_BT).norm();
  if (miss <= kReached) return near;
  const JointVector other = searchPose(*this, wanted, like);
  return (forward(other).position - p_BT).norm() < miss ? other : near;
}

ArmSkeleton ArmKinematics::skeleton(const JointVector& q) const noexcept {
  ArmSkeleton skeleton = std::visit([&](const auto& arm) { return arm.skeleton(q); }, arm_);
  if (hasTool_) skeleton.at[skeleton.count++] = forward(q).position;
  return skeleton;
}

}  // namespace haptiv
