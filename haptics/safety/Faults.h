#pragma once

#include <cstdint>

namespace haptiv {

/// What makes a session stop; bits, so that several can stand.
enum Fault : std::uint32_t {
  kNoFault = 0,
  kFaultNotFinite = 1u << 0,        ///< a value of the tick was NaN or infinite
  kFaultTracking = 1u << 1,         ///< a joint is too far from where it was sent
  kFaultSensorSaturated = 1u << 2,  ///< the handle's sensor is at the end of its range
  kFaultDisconnected = 1u << 3,     ///< the device does not answer
};

/// Names of the faults that stand, comma separated; "none" where there are none.
const char* faultName(Fault fault) noexcept;

}  // namespace haptiv
