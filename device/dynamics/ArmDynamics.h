#pragma once

#include <array>

#include "device/described/DeviceDescription.h"
#include "device/kinematics/ArmKinematics.h"

namespace haptiv {

using JointMatrix = Eigen::Matrix<double, kJointCount, kJointCount>;

/// Rigid-body dynamics of the arm that a description names, for the simulated arm and for computed torque alike:
///
///   M(q) qdd + b(q, qd) = tau + J_BT^T w,   b = C(q, qd) qd + g(q)
/// tau: of the drives at the joints, less friction [N m]; w: the wrench on the tool, in B.
/// M holds the links and, on its diagonal, the rotors' inertia reflected through their gears (drives.inertia): a rotor
/// counts with its own spin alone, as usual where gears are high.
///
/// Own code and not Orocos KDL's, which the tests hold it against: KDL's solvers keep their intermediate values in
/// themselves and refer to their chain, so that they can be neither const nor copied, and take three times as long,
/// which the simulated arm, eight times a tick, has not.
///
/// Joints that the arm has not: M has drives.inertia there, and b is zero. A parallel arm's legs have no bodies: M has
/// drives.inertia of all its joints, and b is zero.
/// Realtime-safe: all but the constructor. Everything in SI units.
class ArmDynamics {
 public:
  /// Throws std::runtime_error where the description has no bodies: what needs them, and what to do.
  explicit ArmDynamics(const DeviceDescription& description);

  /// M(q), symmetric and positive definite [kg m^2]; by composite rigid bodies.
  JointMatrix massMatrix(const JointVector& q) const noexcept;
  /// g(q): what holds the arm against its weight [N m].
  JointVector gravity(const JointVector& q) const noexcept { return bias(q, JointVector::Zero()); }
  /// b(q, qd) [N m].
  JointVector bias(const JointVector& q, const JointVector& qd) const noexcept;
  /// Inverse dynamics, M qdd + b [N m]; by the recursion of Newton and Euler.
  JointVector inverse(const JointVector& q, const JointVector& qd, const JointVector& qdd) const noexcept;
  /// Forward dynamics: qdd [rad/s^2]. Without friction.
  JointVector accelerations(const JointVector& q, const JointVector& qd, const JointVector& torques,
                            const Wrench& onTool_B) const noexcept;

  /// What the simulated arm needs of an instant: M and b for less than the two apart.
  struct Equation {
    JointMatrix mass;
    JointVector bias;
  };
  Equation evaluate(const JointVector& q, const JointVector& qd) const noexcept;

  /// Of the links in the field of gravity, zero where their centres lie in B's origin [J].
  double potentialEnergy(const JointVector& q) const noexcept;

 private:
  /// A link where it is now, in B.
  struct Placed {
    Vector3 axis;     ///< of the joint that moves it
    Vector3 origin;   ///< on that axis
    Vector3 centre;   ///< of mass
    Matrix3 inertia;  ///< about the centre
  };
  using Links = std::array<Placed, kJointCount>;

  Links place(const JointVector& q) const noexcept;
  JointVector inverse(const Links& links, const JointVector& qd, const JointVector& qdd) const noexcept;
  JointMatrix massMatrix(const Links& links) const noexcept;

  ArmKinematics arm_;
  int count_;
  std::array<ChainJoint, kJointCount> joints_;
  std::array<LinkBody, kJointCount> bodies_;
  JointVector rotors_;
  Vector3 gravity_;
};

}  // namespace haptiv
