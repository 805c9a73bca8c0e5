#pragma once

#include <Eigen/Geometry>
#include <numbers>

#include "device/described/DeviceDescription.h"
#include "device/kinematics/ChainOfArm.h"
#include "tests/support/Random.h"

namespace haptiv::test {

/// VISHARD10 as a chain of its links, B's origin at the height of joint 6; links 5 and 8 included.
inline ChainGeometry vishard10Chain(const LinkLengths& links) {
  DeviceDescription description;
  description.links = links;
  return chainOfArm(description);
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
