#include "device/board/VelocityShutOff.h"

#include <algorithm>
#include <cstdlib>

namespace haptiv {

namespace {

/// Impulses between two readings of a counter that may have wrapped.
std::int64_t impulsesBetween(std::int32_t before, std::int32_t now) noexcept {
  const auto turned = static_cast<std::int32_t>(static_cast<std::uint32_t>(now) - static_cast<std::uint32_t>(before));
  return std::abs(static_cast<std::int64_t>(turned));
}

constexpr std::int64_t kLongestGap = 1'000'000;  // [us]; keeps the products below in 64 bits
constexpr std::int64_t kJump = 8;

}  // namespace

void VelocityShutOff::begin(const CircuitThresholds& thresholds, std::int64_t now,
                            const std::array<std::int32_t, kJointCount>& counts) noexcept {
  thresholds_ = thresholds;
  unitBegan_ = now;
  last_ = counts;
  impulses_.fill(0);
  jumps_ = 0;
}

std::uint16_t VelocityShutOff::count(std::int64_t now, const std::array<std::int32_t, kJointCount>& counts) noexcept {
  const std::int64_t unit = thresholds_.velocityTimeUnit;
  const std::int64_t elapsed = std::clamp<std::int64_t>(now - unitBegan_, 0, std::max(kLongestGap, unit));
  const std::int64_t referenceTime = std::max(elapsed, unit);
  std::uint16_t tooFast = 0;
  jumps_ = 0;
  for (int i = 0; i < kJointCount; ++i) {
    const std::int64_t fresh = impulsesBetween(last_[i], counts[i]);
    impulses_[i] += fresh;
    last_[i] = counts[i];
    const std::int64_t reference = static_cast<std::int64_t>(thresholds_.countThreshold[i]) * referenceTime;
    if (impulses_[i] * unit > reference) tooFast |= static_cast<std::uint16_t>(1u << i);
    if (fresh * unit > kJump * reference) jumps_ |= static_cast<std::uint16_t>(1u << i);
  }
  if (elapsed >= unit) {
    unitBegan_ = now;
    impulses_.fill(0);
  }
  return tooFast;
}

}  // namespace haptiv
