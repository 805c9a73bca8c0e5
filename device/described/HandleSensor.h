#pragma once

#include <array>
#include <cstdint>

#include "device/types.h"

namespace haptiv {

/// The six-axis sensor at the handle. What the hand does to it is, in N and N m, in T,
///   wrench = matrix (resolution counts - bias)
struct HandleSensor {
  double forceResolution = 0.02;    ///< [N] per count
  double torqueResolution = 0.001;  ///< [N m] per count
  double forceNoise = 0.02;         ///< standard deviation [N]
  double torqueNoise = 0.0005;      ///< standard deviation [N m]
  double forceRange = 400;          ///< [N], saturates beyond
  double torqueRange = 30;          ///< [N m], saturates beyond
  double bandwidth = 50'265;        ///< of its low-pass [rad/s]: 8 kHz
  Vector6 bias = Vector6::Zero();   ///< what it says of an untouched handle, before the matrix [N], [N m]
  Matrix6 matrix = Matrix6::Identity();

  Vector6 resolution() const noexcept;                      ///< of each axis, per count [N], [N m]
  Vector6 range() const noexcept;                           ///< of each axis [N], [N m]
  std::array<std::int16_t, 6> lastCounts() const noexcept;  ///< at the end of each axis' range
  /// What the counts say before bias and matrix [N], [N m]. Realtime-safe: yes.
  Vector6 raw(const std::array<std::int16_t, 6>& counts) const noexcept;
};

}  // namespace haptiv
