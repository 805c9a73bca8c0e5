#pragma once

#include <cstdint>

namespace haptiv {

/// An incremental encoder at a motor's shaft: countsPerRadian * angle + zero.
///
/// The nearest count; a counter at its end stays there, as wrapping would look like a jump of the arm.
class Encoder {
 public:
  /// @param zero  what it counts at the joint's zero, a whole number
  explicit Encoder(double countsPerRadian, double zero = 0) : countsPerRadian_(countsPerRadian), zero_(zero) {}

  /// @param angle  of the joint, finite [rad]
  /// Realtime-safe: yes.
  std::int32_t count(double angle) const noexcept;
  /// Angle of a count [rad]. Realtime-safe: yes.
  double angle(std::int32_t count) const noexcept { return (count - zero_) / countsPerRadian_; }

 private:
  double countsPerRadian_, zero_;
};

}  // namespace haptiv
