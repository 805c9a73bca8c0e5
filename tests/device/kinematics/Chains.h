#pragma once

#include <Eigen/Geometry>
#include <numbers>

#include "device/DeviceDescription.h"
#include "tests/support/Random.h"

namespace haptiv::test {

/// VISHARD10 as a chain of its links, B's origin at the height of joint 6; links 5 and 8 included.
inline ChainGeometry vishard10Chain(const LinkLengths& links) {
  const Vector3 x = Vector3::UnitX(), z = Vector3::UnitZ();
  const Vector3 axes[] = {z, z, z, z, z, x, x, x, z, x};
  const Vector3 moves[] = {Vector3::Zero(),   links.scara * x, links.scara * x, links.scara * x,    links.scara * x,
                           links.forearm * x, links.lift * z,  links.lift * z,  -links.forearm * x, Vector3::Zero()};
  ChainGeometry chain;
  for (int i = 0; i < kJointCount; ++i) chain.joints.push_back({{moves[i], Matrix3::Identity()}, axes[i]});
  return chain;
}

inline Pose randomPose(Random& random) {
  const Vector3 axis = random.vector<Vector3>(-1, 1).normalized();
  const double angle = random.between(-std::numbers::pi, std::numbers::pi);
  return {random.vector<Vector3>(-0.3, 0.3), Eigen::AngleAxisd(angle, axis).toRotationMatrix()};
}

inline ChainGeometry randomChain(Random& random, int joints) {
  ChainGeometry chain;
  for (int i = 0; i < joints; ++i)
    chain.joints.push_back({randomPose(random), random.vector<Vector3>(-1, 1).normalized()});
  chain.end = randomPose(random);
  return chain;
}

}  // namespace haptiv::test
