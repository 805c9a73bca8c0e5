#include "device/kinematics/SerialChain.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace haptiv {
namespace {

constexpr double kUnit = 1e-9;  // how far from one the length of an axis may be

/// X_AC of X_AB and X_BC.
Pose operator*(const Pose& a, const Pose& b) noexcept {
  return {a.position + a.rotation * b.position, a.rotation * b.rotation};
}

/// The joint's frame, in B, before and after it turns: `before` is that of the joint before it.
Pose mounted(const Pose& before, const ChainJoint& joint) noexcept {
  return before * joint.mount;
}
void turn(Pose& frame, const ChainJoint& joint, double angle) noexcept {
  frame.rotation = frame.rotation * Eigen::AngleAxisd(angle, joint.axis).toRotationMatrix();
}

}  // namespace

SerialChain::SerialChain(const ChainGeometry& geometry)
    : count_(static_cast<int>(geometry.joints.size())), end_(geometry.end) {
  if (geometry.joints.empty() || geometry.joints.size() > joints_.size())
    throw std::invalid_argument("a chain has 1 to " + std::to_string(kJointCount) + " joints");
  for (const ChainJoint& joint : geometry.joints) {
    if (!(std::abs(joint.axis.norm() - 1) <= kUnit))
      throw std::invalid_argument("the axis of a joint is a vector of length one");
  }
  std::copy(geometry.joints.begin(), geometry.joints.end(), joints_.begin());
}

Pose SerialChain::forward(const JointVector& q) const noexcept {
  Pose frame;
  for (int i = 0; i < count_; ++i) {
    frame = mounted(frame, joints_[i]);
    turn(frame, joints_[i], q[i]);
  }
  return frame * end_;
}

ArmPose SerialChain::evaluate(const JointVector& q) const noexcept {
  ArmPose arm;
  arm.J_BT.setZero();
  std::array<Vector3, kJointCount> origins;
  Pose frame;
  for (int i = 0; i < count_; ++i) {
    frame = mounted(frame, joints_[i]);
    origins[i] = frame.position;
    arm.J_BT.col(i).tail<3>() = frame.rotation * joints_[i].axis;
    turn(frame, joints_[i], q[i]);
  }
  arm.X_BT = frame * end_;
  for (int i = 0; i < count_; ++i) {
    const Vector3 axis = arm.J_BT.col(i).tail<3>();
    arm.J_BT.col(i).head<3>() = axis.cross(arm.X_BT.position - origins[i]);
  }
  return arm;
}

ArmSkeleton SerialChain::skeleton(const JointVector& q) const noexcept {
  ArmSkeleton skeleton;
  const auto add = [&skeleton](const Vector3& place) { skeleton.at[skeleton.count++] = place; };
  Pose frame;
  for (int i = 0; i < count_; ++i) {
    frame = mounted(frame, joints_[i]);
    add(frame.position);
    turn(frame, joints_[i], q[i]);
  }
  add((frame * end_).position);
  return skeleton;
}

}  // namespace haptiv
