#include "haptics/passivity/PassivityObserver.h"

#include <algorithm>

namespace haptiv {

void PassivityObserver::seeMass(const HandMeetsTool& now, double mass, double period) noexcept {
  if (started) {
    const Vector3 way = 0.5 * period * (last.ballVelocity + now.ballVelocity);
    const Vector3 lag = 0.5 * (last.tool - last.ball + now.tool - now.ball);
    const double gained = 0.5 * mass * (now.ballVelocity.squaredNorm() - last.ballVelocity.squaredNorm());
    energy += last.handForce.dot(way) - gained - lag.dot(now.handForce - last.handForce);
  }
  started = true;
  last = now;
}

void PassivityObserver::seeTool(const HandMeetsTool& now) noexcept {
  if (started) energy -= heldForce.dot(now.tool - last.tool);
  started = true;
  last = now;
}

void PassivityObserver::forgetSurplus(double stored) noexcept {
  energy = std::min(energy, kReserve + stored);
}

}  // namespace haptiv
