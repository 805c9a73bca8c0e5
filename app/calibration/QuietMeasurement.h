#pragma once

#include <cstdint>

#include "device/calibration/Samples.h"

namespace haptiv {

/// Collects what a device says for so many ticks, in two halves, so that a drift shows.
class QuietMeasurement {
 public:
  /// @param ticks  as many readings; at least 2
  explicit QuietMeasurement(std::int64_t ticks) : half_((ticks + 1) / 2) {}

  void take(const DeviceReading& reading) noexcept { (first_.count() < half_ ? first_ : second_).take(reading); }
  bool isDone() const noexcept { return second_.count() >= half_; }
  double progress() const noexcept {  ///< 0 to 1
    return static_cast<double>(first_.count() + second_.count()) / static_cast<double>(2 * half_);
  }
  const Samples& first() const noexcept { return first_; }
  const Samples& second() const noexcept { return second_; }

 private:
  std::int64_t half_;
  Samples first_, second_;
};

}  // namespace haptiv
