#include "haptics/safety/OscillationMonitor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/safety/Faults.h"

namespace haptiv {
namespace {

constexpr double kHalfSwing = 0.5 / OscillationMonitor::kSlowest;  // [s]

/// Goes towards `value` by the share of a low-pass with this time constant.
template <typename Value>
void follow(Value& mean, const Value& value, double share) noexcept {
  mean += share * (value - mean);
}

/// By which a low-pass of this time constant follows in a tick.
double share(double period, double seconds) noexcept {
  return -std::expm1(-period / seconds);
}

double meanSquare(double amplitude) noexcept {
  return amplitude * amplitude / 2;
}

}  // namespace

OscillationMonitor::OscillationMonitor(const SafetyThresholds& safety, double period)
    : leastVelocitySquare_(meanSquare(safety.oscillationSpeed)),
      leastForceSquare_(meanSquare(kForceShare * safety.forceClamp)),
      period_(period),
      fastShare_(share(period, 1 / (2 * std::numbers::pi * kSlowest))),
      latelyShare_(share(period, kLately)),
      beforeShare_(share(period, kBefore)) {}

bool OscillationMonitor::swings(const Vector3& now, double leastSquare, SwingState& state) const noexcept {
  follow(state.mean, now, fastShare_);
  const Vector3 swing = now - state.mean;
  const bool changed = swing.dot(state.side) <= 0;
  state.time = changed ? 0 : state.time + period_;
  if (changed) state.side = swing;
  follow(state.lately, swing.squaredNorm(), latelyShare_);
  follow(state.before, swing.squaredNorm(), beforeShare_);
  return state.lately >= leastSquare && state.lately >= kKeeps * state.before && state.time < kHalfSwing;
}

std::uint32_t OscillationMonitor::operator()(const Swinging& now, OscillationState& state) const noexcept {
  if (!state.started) {
    state.velocity.mean = now.velocity;
    state.force.mean = now.force;
    state.energyLately = state.energyBefore = now.energy;
  }
  state.started = true;
  const bool moves = swings(now.velocity, leastVelocitySquare_, state.velocity);
  const bool pushes = swings(now.force, leastForceSquare_, state.force);
  follow(state.energyLately, now.energy, latelyShare_);
  follow(state.energyBefore, now.energy, beforeShare_);
  const bool stays = state.velocity.mean.squaredNorm() < state.velocity.lately;
  const bool fed = state.energyLately < 0 && state.energyLately < state.energyBefore;
  const bool byItself = (moves || pushes) && (stays || fed);
  state.time = std::max(0.0, state.time + (byItself ? period_ : -period_));
  return state.time > kLongest ? kFaultOscillation : kNoFault;
}

}  // namespace haptiv
