#include "haptics/passivity/PassivityController.h"

#include <algorithm>
#include <cmath>

namespace haptiv {

AddedDamping dampMass(double missing, const Vector3& velocity, double mass, double period, double most) noexcept {
  const double speed = velocity.norm();
  if (!(missing > 0) || !(speed > 0)) return {};
  constexpr double kSlowest = 1e-3;  // the damping stays finite; the rest is for the next tick
  const double keeps = std::sqrt(std::max(0.0, 1 - 2 * missing / (mass * speed * speed)));
  const double share = std::max({kSlowest, keeps, 1 - most * period / (mass * speed)});
  return {(1 / share - 1) * mass / period, -(1 - share) * mass / period * velocity};
}

AddedDamping dampTool(double missing, const Vector3& velocity, double mass, double period, double most) noexcept {
  const double speed = velocity.norm();
  if (!(missing > 0) || !(speed > 0)) return {};
  const double damping = std::min({missing / (speed * speed * period), mass / (4 * period), most / speed});
  return {damping, -damping * velocity};
}

}  // namespace haptiv
