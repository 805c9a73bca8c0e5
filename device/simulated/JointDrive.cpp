#include "device/simulated/JointDrive.h"

#include <algorithm>
#include <cmath>

namespace haptiv {
void JointDrive::advance(double setPoint, double load, double dt) noexcept {
  const double wanted = std::isfinite(setPoint) ? std::clamp(setPoint, -limits_.rate, limits_.rate) : 0;
  // The loop's exact answer over the step; a constant torque within it.
  const double acceleration = (wanted - rate_) * -std::expm1(-limits_.bandwidth * dt) / dt;
  const double stops = limits_.inertia * std::abs(rate_) / dt;  // no friction turns the motion round
  const double friction =
      std::copysign(std::min(limits_.coulomb + limits_.viscous * std::abs(rate_), stops), rate_);
  const double outside = load - friction;
  torque_ = std::clamp(limits_.inertia * acceleration - outside, -limits_.torque, limits_.torque);
  const double before = rate_;
  rate_ += (torque_ + outside) / limits_.inertia * dt;
  angle_ += 0.5 * (before + rate_) * dt;
}

}  // namespace haptiv
