#include "device/redundancy/DriftCorrection.h"

#include <Eigen/Geometry>

namespace haptiv {

Vector6 driftCorrection(const Pose& desired, const Pose& actual, double gain) noexcept {
  // AngleAxis goes by way of a quaternion and atan2: exact near zero and near half a turn.
  const Eigen::AngleAxisd turn(Matrix3(desired.rotation * actual.rotation.transpose()));
  Vector6 twist;
  twist << desired.position - actual.position, turn.angle() * turn.axis();
  return gain * twist;
}

}  // namespace haptiv
