#pragma once

#include <memory>

#include "device/described/DeviceDescription.h"

namespace haptiv {

/// VISHARD10 in Orocos KDL: the peer of our kinematics. Without KDL at build time there is none.
class KdlArm {
 public:
  static bool isBuiltIn();
  /// Throws std::logic_error where it is not built in.
  explicit KdlArm(const LinkLengths& links);
  ~KdlArm();

  /// Frame and Jacobian of the tool, by ChainFkSolverPos_recursive and ChainJntToJacSolver; a number made of both.
  double forwardAndJacobian(const JointVector& q);
  /// Rates by ChainIkSolverVel_pinv, its Jacobian included.
  JointVector rates(const JointVector& q, const Vector6& twist);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
