#pragma once

#include <cstdint>

namespace haptiv {

/// An incremental encoder at a motor's shaft, counting from the joint's zero.
///
/// The nearest count; a counter at its end stays there, as wrapping would look like a jump of the arm.
class Encoder {
 public:
  explicit Encoder(double countsPerRadian) : countsPerRadian_(countsPerRadian) {}

  /// @param angle  of the joint, finite [rad]
  /// Realtime-safe: yes.
  std::int32_t count(double angle) const noexcept;
  /// Angle of a count [rad]. Realtime-safe: yes.
  double angle(std::int32_t count) const noexcept { return count / countsPerRadian_; }

 private:
  double countsPerRadian_;
};

}  // namespace haptiv
