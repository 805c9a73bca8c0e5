#include "haptics/safety/Faults.h"

#include <array>

namespace haptiv {

const char* faultName(Fault fault) noexcept {
  // One literal for every set of the four bits: nothing to build, nothing to free.
  static constexpr std::array<const char*, 16> kNames = {
      "none",
      "not finite",
      "tracking error",
      "not finite, tracking error",
      "sensor saturated",
      "not finite, sensor saturated",
      "tracking error, sensor saturated",
      "not finite, tracking error, sensor saturated",
      "device disconnected",
      "not finite, device disconnected",
      "tracking error, device disconnected",
      "not finite, tracking error, device disconnected",
      "sensor saturated, device disconnected",
      "not finite, sensor saturated, device disconnected",
      "tracking error, sensor saturated, device disconnected",
      "not finite, tracking error, sensor saturated, device disconnected",
  };
  const auto bits = static_cast<std::uint32_t>(fault);
  return bits < kNames.size() ? kNames[bits] : "unknown fault";
}

}  // namespace haptiv
