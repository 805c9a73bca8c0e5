#pragma once

#include <kdl/chain.hpp>

#include "device/described/ArmBodies.h"
#include "device/described/ChainGeometry.h"

/// Orocos KDL's view of an arm.
namespace haptiv::test {

inline KDL::Vector toKdl(const Vector3& v) {
  return {v.x(), v.y(), v.z()};
}

inline KDL::Frame toKdl(const Pose& pose) {
  const Matrix3& R = pose.rotation;
  return {KDL::Rotation(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)),
          toKdl(pose.position)};
}

inline KDL::Segment mounting(const Pose& pose) {
  return KDL::Segment(KDL::Joint(KDL::Joint::None), toKdl(pose));
}

/// Joints without bodies, and the tool at the end.
inline KDL::Chain toKdl(const ChainGeometry& geometry, const Pose& tool) {
  KDL::Chain chain;
  for (const ChainJoint& joint : geometry.joints) {
    chain.addSegment(mounting(joint.mount));
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Vector::Zero(), toKdl(joint.axis), KDL::Joint::RotAxis)));
  }
  chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), toKdl(geometry.end) * toKdl(tool)));
  return chain;
}

/// Joints with bodies, and with rotors of this inertia [kg m^2].
inline KDL::Chain toKdl(const ChainGeometry& geometry, const ArmBodies& bodies, const JointVector& rotors) {
  KDL::Chain chain;
  for (std::size_t i = 0; i < geometry.joints.size(); ++i) {
    const ChainJoint& joint = geometry.joints[i];
    const LinkBody& body = bodies.links[i];
    const Matrix3& I = body.inertia;
    chain.addSegment(mounting(joint.mount));
    chain.addSegment(KDL::Segment(
        KDL::Joint(KDL::Vector::Zero(), toKdl(joint.axis), KDL::Joint::RotAxis, 1, 0, rotors[static_cast<int>(i)]),
        KDL::Frame::Identity(),
        KDL::RigidBodyInertia(body.mass, toKdl(body.centre),
                              KDL::RotationalInertia(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)))));
  }
  return chain;
}

}  // namespace haptiv::test
