#include "haptics/safety/EncoderMonitor.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "haptics/safety/Faults.h"

namespace haptiv {
namespace {

constexpr double kJump = 3;       // times the speed at which a joint is too fast
constexpr double kFewCounts = 8;  // that any encoder may step by, however short the tick

}  // namespace

EncoderMonitor::EncoderMonitor(const DeviceDescription& description, double period)
    : ticksPerUnit_(std::max(1, static_cast<std::int32_t>(std::round(description.safety.velocityTimeUnit / period)))),
      mostStill_(std::max(kStuckTicks, static_cast<std::int32_t>(std::ceil(kStuckTime / period)))) {
  const JointVector perSecond = description.safety.countThreshold / description.safety.velocityTimeUnit;
  for (int i = 0; i < kJointCount; ++i) {
    const auto joint = static_cast<std::size_t>(i);
    threshold_[joint] = static_cast<std::int64_t>(std::ceil(perSecond[i] * period * ticksPerUnit_));
    jump_[joint] = static_cast<std::int64_t>(std::ceil(kJump * perSecond[i] * period + kFewCounts));
  }
}

std::uint32_t EncoderMonitor::operator()(const DeviceReading& reading, const JointVector* desired,
                                         EncoderState& state) const noexcept {
  std::uint32_t faults = kNoFault;
  if (stuck(reading, desired, state)) faults |= kFaultEncoderStuck;
  if (state.started) faults |= moved(reading, state);
  state.started = true;
  state.counts = reading.encoderCounts;
  return faults;
}

std::uint32_t EncoderMonitor::moved(const DeviceReading& reading, EncoderState& state) const noexcept {
  std::uint32_t faults = kNoFault;
  for (std::size_t i = 0; i < kJointCount; ++i) {
    const std::int64_t step = std::abs(std::int64_t{reading.encoderCounts[i]} - state.counts[i]);
    if (step > jump_[i]) faults |= kFaultEncoderJump;
    if (step <= jump_[i]) state.impulses[i] += step;
    if (state.impulses[i] > threshold_[i]) faults |= kFaultJointSpeed;
  }
  if (++state.ticksOfUnit >= ticksPerUnit_) {
    state.ticksOfUnit = 0;
    state.impulses = {};
  }
  return faults;
}

bool EncoderMonitor::stuck(const DeviceReading& reading, const JointVector* desired,
                           EncoderState& state) const noexcept {
  const bool before = state.sent;
  state.sent = desired != nullptr;
  if (desired == nullptr) return false;
  bool found = false;
  for (int i = 0; i < kJointCount; ++i) {
    const auto joint = static_cast<std::size_t>(i);
    const bool still = before && reading.encoderCounts[joint] == state.counts[joint];
    if (!still) state.sentAt[i] = (*desired)[i];
    state.still[joint] = still ? std::min(state.still[joint] + 1, mostStill_ + 1) : 0;
    found = found || (state.still[joint] > mostStill_ && std::abs((*desired)[i] - state.sentAt[i]) > kStuck);
  }
  return found;
}

}  // namespace haptiv
