#pragma once

#include <array>
#include <cstdint>

#include "haptics/Measured.h"
#include "haptics/safety/Faults.h"

namespace haptiv {

/// What looks at a tick's inputs and finds what a session must not go on with.
class Monitors {
 public:
  explicit Monitors(const DeviceDescription& description);

  /// @param desired  joint angles that the joint controller was given; null where the arm follows none
  /// @return         Fault bits of this tick, not latched
  /// Realtime-safe: yes.  Thread: servo.
  std::uint32_t operator()(const DeviceReading& reading, const Measured& measured,
                           const JointVector* desired) const noexcept;

 private:
  double trackingErrorLimit_;
  std::array<std::int32_t, 6> saturation_{};  ///< sensor counts at the end of the range
};

}  // namespace haptiv
