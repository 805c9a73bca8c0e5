#include "device/simulated/JointDrive.h"

#include <algorithm>
#include <cmath>

namespace haptiv {

void JointDrive::advance(double setPoint, double load, double dt) noexcept {
  const double wanted = std::isfinite(setPoint) ? std::clamp(setPoint, -limits_.rate, limits_.rate) : 0;
  // The loop's exact answer over the step; a constant torque within it.
  const double acceleration = (wanted - rate_) * -std::expm1(-limits_.bandwidth * dt) / dt;
  torque_ = std::clamp(limits_.inertia * acceleration - load, -limits_.torque, limits_.torque);
  const double before = rate_;
  rate_ += (torque_ + load) / limits_.inertia * dt;
  angle_ += 0.5 * (before + rate_) * dt;
}

}  // namespace haptiv
