#include "device/kinematics/ChainOfArm.h"

namespace haptiv {
namespace {

/// Table I of the paper.
ChainGeometry vishard10(const LinkLengths& links) {
  const Vector3 x = Vector3::UnitX(), z = Vector3::UnitZ();
  const Vector3 axes[] = {z, z, z, z, z, x, x, x, z, x};
  const Vector3 moves[] = {Vector3::Zero(),   links.scara * x, links.scara * x, links.scara * x,    links.scara * x,
                           links.forearm * x, links.lift * z,  links.lift * z,  -links.forearm * x, Vector3::Zero()};
  ChainGeometry chain;
  for (int i = 0; i < kJointCount; ++i) chain.joints.push_back({{moves[i], Matrix3::Identity()}, axes[i]});
  return chain;
}

}  // namespace

ChainGeometry chainOfArm(const DeviceDescription& description) {
  return description.isVishard10() ? vishard10(description.links) : description.chain;
}

}  // namespace haptiv
