#include "app/bench/kinematics/KdlArm.h"

#include <stdexcept>

#ifdef HAPTIV_HAS_KDL

#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>
#include <kdl/chainjnttojacsolver.hpp>

namespace haptiv {
namespace {

/// Table I: each joint turns about its axis, then the link moves on.
KDL::Chain vishard10(const LinkLengths& links) {
  using KDL::Joint;
  const KDL::Vector none, scara(links.scara, 0, 0), forearm(links.forearm, 0, 0), lift(0, 0, links.lift);
  KDL::Chain chain;
  const auto add = [&chain](Joint::JointType axis, const KDL::Vector& link) {
    chain.addSegment(KDL::Segment(Joint(axis), KDL::Frame(link)));
  };
  for (int i = 0; i < 4; ++i) add(Joint::RotZ, scara);
  add(Joint::RotZ, forearm);
  add(Joint::RotX, lift);
  add(Joint::RotX, lift);
  add(Joint::RotX, -forearm);
  add(Joint::RotZ, none);
  add(Joint::RotX, none);
  return chain;
}

}  // namespace

struct KdlArm::Parts {
  explicit Parts(const LinkLengths& links) : chain(vishard10(links)) {}
  KDL::Chain chain;
  KDL::ChainFkSolverPos_recursive forward{chain};
  KDL::ChainJntToJacSolver jacobian{chain};
  KDL::ChainIkSolverVel_pinv inverse{chain};
  KDL::JntArray angles{kJointCount}, rates{kJointCount};
  KDL::Jacobian J{kJointCount};
  KDL::Frame frame;
};

bool KdlArm::isBuiltIn() {
  return true;
}

KdlArm::KdlArm(const LinkLengths& links) : parts_(std::make_unique<Parts>(links)) {}
KdlArm::~KdlArm() = default;

double KdlArm::forwardAndJacobian(const JointVector& q) {
  parts_->angles.data = q;
  parts_->forward.JntToCart(parts_->angles, parts_->frame);
  parts_->jacobian.JntToJac(parts_->angles, parts_->J);
  return parts_->frame.p.x() + parts_->J(0, 0);
}

JointVector KdlArm::rates(const JointVector& q, const Vector6& twist) {
  parts_->angles.data = q;
  const KDL::Twist wanted({twist[0], twist[1], twist[2]}, {twist[3], twist[4], twist[5]});
  parts_->inverse.CartToJnt(parts_->angles, wanted, parts_->rates);
  return parts_->rates.data;
}

}  // namespace haptiv

#else

namespace haptiv {

struct KdlArm::Parts {};

bool KdlArm::isBuiltIn() {
  return false;
}

KdlArm::KdlArm(const LinkLengths&) {
  throw std::logic_error("built without Orocos KDL");
}
KdlArm::~KdlArm() = default;

double KdlArm::forwardAndJacobian(const JointVector&) {
  return 0;
}

JointVector KdlArm::rates(const JointVector&, const Vector6&) {
  return JointVector::Zero();
}

}  // namespace haptiv

#endif
