#include "device/board/BoardSettings.h"

#include <algorithm>
#include <cmath>

namespace haptiv {

namespace {

std::int64_t microseconds(double seconds) {
  return std::llround(std::clamp(seconds * 1e6, 1., 1e8));
}

}  // namespace

BoardSettings boardSettings(const DeviceDescription& description) {
  const SafetyThresholds& safety = description.safety;
  BoardSettings settings;
  settings.thresholds.watchdogTime = microseconds(safety.watchdogTime);
  settings.thresholds.velocityTimeUnit = microseconds(safety.velocityTimeUnit);
  for (int i = 0; i < kJointCount; ++i)
    settings.thresholds.countThreshold[i] =
        static_cast<std::uint32_t>(std::clamp(safety.countThreshold[i], 1., 0x7fffffffp0));
  settings.rateLimit = description.drives.rateLimit;
  settings.torqueLimit = description.drives.torqueLimit;
  return settings;
}

bool noLooser(const CircuitThresholds& wanted, const CircuitThresholds& builtFor) noexcept {
  if (wanted.watchdogTime < 1 || wanted.watchdogTime > builtFor.watchdogTime) return false;
  if (wanted.velocityTimeUnit < 1 || wanted.velocityTimeUnit > 1'000'000) return false;
  for (int i = 0; i < kJointCount; ++i) {
    const auto wantedCount = static_cast<std::int64_t>(wanted.countThreshold[i]);
    const auto builtCount = static_cast<std::int64_t>(builtFor.countThreshold[i]);
    // Neither a faster joint nor more impulses before the circuit sees it.
    if (wantedCount < 1 || wantedCount > builtCount) return false;
    if (wantedCount * builtFor.velocityTimeUnit > builtCount * wanted.velocityTimeUnit) return false;
  }
  return true;
}

}  // namespace haptiv
