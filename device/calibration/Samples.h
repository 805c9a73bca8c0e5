#pragma once

#include <cstdint>

#include "device/described/DeviceDescription.h"

namespace haptiv {

/// What a device said for a while in which nothing was to happen: sums over its raw counts, exact.
/// Realtime-safe: yes.
class Samples {
 public:
  void take(const DeviceReading& reading) noexcept;
  std::int64_t count() const noexcept { return count_; }
  bool connected() const noexcept { return connected_; }  ///< in every reading

  /// Mean of each axis [counts]. Of none: zero.
  Vector6 mean() const noexcept;
  /// Standard deviation of each axis [counts].
  Vector6 deviation() const noexcept;
  /// Smallest and largest count of an axis.
  std::int16_t lowest(int axis) const noexcept { return lowest_[static_cast<std::size_t>(axis)]; }
  std::int16_t highest(int axis) const noexcept { return highest_[static_cast<std::size_t>(axis)]; }

  /// Counts of the encoders in the newest reading.
  const PoseCounts& encoderCounts() const noexcept { return newest_; }
  /// How far each encoder went to and fro [counts].
  JointVector movement() const noexcept;

 private:
  std::int64_t count_ = 0;
  bool connected_ = true;
  std::array<std::int64_t, 6> sum_{}, squares_{};
  std::array<std::int16_t, 6> lowest_{}, highest_{};
  PoseCounts newest_{}, least_{}, most_{};
};

}  // namespace haptiv
