#pragma once

#include <array>
#include <cstdint>

#include "device/types.h"

namespace haptiv {

/// The encoder counts that a device shall report at the arm's present pose.
using PoseCounts = std::array<std::int32_t, kJointCount>;

/// What a device has whose encoders are incremental: they know nothing of the arm's pose once power was lost, so they
/// are told. Thread: the one that owns the session; not while the servo runs.
class Homing {
 public:
  virtual ~Homing() = default;
  /// Whether the encoders have been told since the device was switched on.
  virtual bool homed() const = 0;
  /// Tells them, the drives being off. Throws std::runtime_error, what and what to do, where the device refuses.
  virtual void home(const PoseCounts& counts) = 0;
};

}  // namespace haptiv
