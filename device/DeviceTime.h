#pragma once

#include <cstdint>

namespace haptiv {

/// Time from one reading to the next by the device's clock [s]; 0: it is the same one again. Where the device tells no
/// time, or its clock has begun anew or tells of longer than a device may be silent, it is taken to be the servo's
/// period: what watches the joints must not be put off by a clock that runs wild.
///
/// @param before, now  DeviceReading::deviceTime [us]
/// Realtime-safe: yes.
inline double timeBetween(std::int64_t before, std::int64_t now, double period) noexcept {
  constexpr double kLongest = 0.1;  // [s]
  if (before == 0 || now == 0) return period;
  const double passed = 1e-6 * (static_cast<double>(now) - static_cast<double>(before));
  return passed >= 0 && passed <= kLongest ? passed : period;
}

}  // namespace haptiv
