#pragma once

#include <string>

namespace haptiv {

struct KinematicsOptions {
  std::string q;  ///< ten joint angles [rad] with commas between
  bool json = false;
};

/// `haptiv kinematics`: pose, Jacobian and dexterity of VISHARD10 at these joint angles.
int describePose(const KinematicsOptions& options);

}  // namespace haptiv
