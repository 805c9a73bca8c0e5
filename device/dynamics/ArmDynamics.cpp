#include "device/dynamics/ArmDynamics.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>
#include <string>

#include "device/kinematics/ChainOfArm.h"

namespace haptiv {

ArmDynamics::ArmDynamics(const DeviceDescription& description)
    : arm_(description),
      count_(description.delta ? 0 : description.jointCount()),
      rotors_(description.drives.inertia),
      gravity_(description.bodies.gravity) {
  const std::vector<LinkBody>& links = description.bodies.links;
  if (static_cast<int>(links.size()) != count_)
    throw std::runtime_error("the arm " + description.name + " has " + std::to_string(count_) + " joints and " +
                             std::to_string(links.size()) +
                             " bodies, so its dynamics are not known; give its description a [[bodies.link]] for each "
                             "joint, or choose a control without a model of the arm");
  const ChainGeometry chain = chainOfArm(description);
  std::copy(chain.joints.begin(), chain.joints.end(), joints_.begin());
  std::copy(links.begin(), links.end(), bodies_.begin());
}

ArmDynamics::Links ArmDynamics::place(const JointVector& q) const noexcept {
  Links links;
  Matrix3 R = Matrix3::Identity();
  Vector3 origin = Vector3::Zero();
  for (int i = 0; i < count_; ++i) {
    const ChainJoint& joint = joints_[i];
    origin += R * joint.mount.position;
    R = R * joint.mount.rotation;
    links[i].axis = R * joint.axis;
    links[i].origin = origin;
    R = R * Eigen::AngleAxisd(q[i], joint.axis).toRotationMatrix();
    links[i].centre = origin + R * bodies_[i].centre;
    links[i].inertia = R * bodies_[i].inertia * R.transpose();
  }
  return links;
}

/// Outwards the motion of each link, inwards the force F and the moment N about B's origin that it takes to move them.
/// The base accelerates upwards in place of gravity.
JointVector ArmDynamics::inverse(const Links& links, const JointVector& qd, const JointVector& qdd) const noexcept {
  std::array<Vector3, kJointCount> forces, moments;
  Vector3 spin = Vector3::Zero(), spinRate = Vector3::Zero();
  Vector3 origin = Vector3::Zero(), acceleration = -gravity_;  // of the point `origin` of the link before
  for (int i = 0; i < count_; ++i) {
    const Placed& link = links[i];
    const auto accelerationAt = [&](const Vector3& r) {  // away from `origin`
      return Vector3(acceleration + spinRate.cross(r) + spin.cross(spin.cross(r)));
    };
    acceleration = accelerationAt(link.origin - origin);
    origin = link.origin;
    const Vector3 turning = qd[i] * link.axis;
    spinRate += qdd[i] * link.axis + spin.cross(turning);
    spin += turning;
    forces[i] = bodies_[i].mass * accelerationAt(link.centre - origin);
    moments[i] = link.inertia * spinRate + spin.cross(link.inertia * spin) + link.centre.cross(forces[i]);
  }
  JointVector torques = rotors_.cwiseProduct(qdd);
  Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
  for (int i = count_ - 1; i >= 0; --i) {
    force += forces[i];
    moment += moments[i];
    torques[i] += links[i].axis.dot(moment - links[i].origin.cross(force));
  }
  return torques;
}

/// Column i is what the links beyond joint i, as one body, put on the joints when that joint alone accelerates.
JointMatrix ArmDynamics::massMatrix(const Links& links) const noexcept {
  JointMatrix M = rotors_.asDiagonal();
  double mass = 0;
  Vector3 moment = Vector3::Zero();   // sum of m c
  Matrix3 inertia = Matrix3::Zero();  // about B's origin
  for (int i = count_ - 1; i >= 0; --i) {
    const Placed& link = links[i];
    const double m = bodies_[i].mass;
    mass += m;
    moment += m * link.centre;
    inertia +=
        link.inertia + m * (link.centre.squaredNorm() * Matrix3::Identity() - link.centre * link.centre.transpose());
    const Vector3 lever = link.axis.cross(link.origin);
    const Vector3 p = link.axis.cross(moment) - mass * lever;     // momentum at one rad/s
    const Vector3 L = inertia * link.axis - moment.cross(lever);  // angular, about B's origin
    for (int j = i; j >= 0; --j) {
      const double entry = links[j].axis.dot(L - links[j].origin.cross(p));
      M(i, j) += entry;
      if (j != i) M(j, i) = M(i, j);
    }
  }
  return M;
}

JointMatrix ArmDynamics::massMatrix(const JointVector& q) const noexcept {
  return massMatrix(place(q));
}

JointVector ArmDynamics::bias(const JointVector& q, const JointVector& qd) const noexcept {
  return inverse(place(q), qd, JointVector::Zero());
}

JointVector ArmDynamics::inverse(const JointVector& q, const JointVector& qd, const JointVector& qdd) const noexcept {
  return inverse(place(q), qd, qdd);
}

ArmDynamics::Equation ArmDynamics::evaluate(const JointVector& q, const JointVector& qd) const noexcept {
  const Links links = place(q);
  return {massMatrix(links), inverse(links, qd, JointVector::Zero())};
}

JointVector ArmDynamics::accelerations(const JointVector& q, const JointVector& qd, const JointVector& torques,
                                       const Wrench& onTool_B) const noexcept {
  const Equation now = evaluate(q, qd);
  const Jacobian J_BT = arm_.jacobian(q);
  const JointVector outside =
      J_BT.topRows<3>().transpose() * onTool_B.force + J_BT.bottomRows<3>().transpose() * onTool_B.torque;
  return now.mass.llt().solve(torques - now.bias + outside);
}

double ArmDynamics::potentialEnergy(const JointVector& q) const noexcept {
  const Links links = place(q);
  double energy = 0;
  for (int i = 0; i < count_; ++i) energy -= bodies_[i].mass * gravity_.dot(links[i].centre);
  return energy;
}

}  // namespace haptiv
