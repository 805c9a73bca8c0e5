#include "haptics/safety/OscillationMonitor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/safety/Faults.h"

namespace haptiv {
namespace {

constexpr double kSlowest = 0.025;                      // [s] a half swing at 20 Hz
constexpr double kStillAlive = 0.9;                     // of the peak before
constexpr double kHighPass = 2 * std::numbers::pi * 5;  // [rad/s]

}  // namespace

std::uint32_t OscillationMonitor::operator()(const Vector3& velocity, OscillationState& state) const noexcept {
  bool found = false;
  for (int i = 0; i < 3; ++i) found = swings(velocity[i], state.axis[static_cast<std::size_t>(i)]) || found;
  return found ? kFaultOscillation : kNoFault;
}

bool OscillationMonitor::swings(double velocity, SwingState& state) const noexcept {
  state.mean += std::min(1.0, kHighPass * period_) * (velocity - state.mean);
  const double swing = velocity - state.mean;
  const bool up = swing > 0;
  if (up != state.up) {
    const bool goesOn = state.peak >= least_ && state.time <= kSlowest;
    const bool alive = state.peak >= kStillAlive * state.lastPeak;
    state.halfSwings = goesOn && alive ? state.halfSwings + 1 : 0;
    state.lastPeak = state.peak;
    state.peak = 0;
    state.time = 0;
    state.up = up;
  }
  state.peak = std::max(state.peak, std::abs(swing));
  state.time += period_;
  if (state.time > kSlowest) state.halfSwings = 0;
  return state.halfSwings >= kHalfSwings;
}

}  // namespace haptiv
