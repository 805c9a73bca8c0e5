#include "haptics/safety/EncoderMonitor.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "device/DeviceTime.h"
#include "haptics/safety/Faults.h"

namespace haptiv {
namespace {

constexpr double kJump = 3;       // times the speed at which a joint is too fast
constexpr double kFewCounts = 8;  // that any encoder may step by, however short the tick

}  // namespace

EncoderMonitor::EncoderMonitor(const DeviceDescription& description, double period)
    : period_(period),
      ticksPerUnit_(std::max(1, static_cast<std::int32_t>(std::round(description.safety.velocityTimeUnit / period)))),
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
  if (!reading.connected) {
    state = {};
    return kNoFault;
  }
  if (desired == nullptr) state.sent = false;
  const double ticks = timeBetween(state.deviceTime, reading.deviceTime, period_) / period_;
  if (state.started && ticks == 0) return kNoFault;
  std::uint32_t faults = kNoFault;
  if (stuck(reading, desired, state)) faults |= kFaultEncoderStuck;
  if (state.started) faults |= moved(reading, ticks, state);
  state.started = true;
  state.deviceTime = reading.deviceTime;
  state.counts = reading.encoderCounts;
  return faults;
}

/// @param ticks  since the reading before; one that comes late may tell of as much more, an early one of no less
std::uint32_t EncoderMonitor::moved(const DeviceReading& reading, double ticks, EncoderState& state) const noexcept {
  std::uint32_t faults = kNoFault;
  state.ticksOfUnit += ticks;
  const double longer = std::max(1., ticks);
  const double longerUnit = std::max(1., state.ticksOfUnit / ticksPerUnit_);
  for (std::size_t i = 0; i < kJointCount; ++i) {
    const std::int64_t step = std::abs(std::int64_t{reading.encoderCounts[i]} - state.counts[i]);
    const bool jumps = static_cast<double>(step) > longer * static_cast<double>(jump_[i]);
    if (jumps) faults |= kFaultEncoderJump;
    if (!jumps) state.impulses[i] += step;
    if (static_cast<double>(state.impulses[i]) > longerUnit * static_cast<double>(threshold_[i]))
      faults |= kFaultJointSpeed;
  }
  if (state.ticksOfUnit >= ticksPerUnit_) {
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
