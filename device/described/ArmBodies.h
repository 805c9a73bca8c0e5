#pragma once

#include <vector>

#include "device/types.h"

namespace haptiv {

/// What moves with one joint, as a rigid body. Its frame turns with the joint: at angle zero it is the joint's frame as
/// the chain mounts it, for VISHARD10 with the axes of B.
struct LinkBody {
  double mass = 0;                    ///< [kg]
  Vector3 centre = Vector3::Zero();   ///< of mass [m]
  Matrix3 inertia = Matrix3::Zero();  ///< about the centre of mass [kg m^2]
};

/// The arm's links as bodies, joint 1 first; none where the description does not tell them.
struct ArmBodies {
  std::vector<LinkBody> links;
  Vector3 gravity{0, 0, -9.81};  ///< in B [m/s^2]
};

}  // namespace haptiv
