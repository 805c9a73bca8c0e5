#include "haptics/control/RotationalAdmittance.h"

#include <Eigen/Geometry>

namespace haptiv {

Vector3 nextRate(const RotationState& state, const Vector3& torque, double inertia, double damping,
                 double dt) noexcept {
  return (inertia * state.rate + dt * torque) / (inertia + dt * damping);
}

Matrix3 turned(const Matrix3& rotation, const Vector3& rate, double dt) noexcept {
  const double speed = rate.norm();
  if (!(speed > 0)) return rotation;
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(speed * dt, rate / speed));
  return (turn * Eigen::Quaterniond(rotation)).normalized().toRotationMatrix();
}

}  // namespace haptiv
