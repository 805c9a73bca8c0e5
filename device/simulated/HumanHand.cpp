#include "device/simulated/HumanHand.h"

#include <cmath>

namespace haptiv {

Vector3 HumanHand::pull(const HandTarget& target, const Vector3& position, const Vector3& velocity,
                        double dt) noexcept {
  if (!target.holding || !target.position.allFinite()) {
    holding_ = false;
    return Vector3::Zero();
  }
  if (!holding_) {
    holding_ = true;
    position_ = position;
    velocity_ = velocity;
  }
  follow(target.position, dt);
  const Vector3 force = model_.stiffness * (position_ - position) + model_.damping * (velocity_ - velocity);
  const double strength = force.norm();
  return strength > model_.peakForce ? Vector3(force * (model_.peakForce / strength)) : force;
}

/// The exact answer of x'' = w^2 (target - x) - 2 w x' to a target at rest: stable for every dt.
void HumanHand::follow(const Vector3& target, double dt) noexcept {
  const double w = model_.bandwidth;
  const double decay = std::exp(-w * dt);
  const Vector3 offset = position_ - target;
  const Vector3 slope = velocity_ + w * offset;
  position_ = target + decay * (offset + dt * slope);
  velocity_ = decay * (velocity_ - w * dt * slope);
}

}  // namespace haptiv
