#pragma once

#include <cstdint>

namespace haptiv {

/// As two's complement counters do it. Realtime-safe: yes.
constexpr std::int32_t sumWrapping(std::int32_t a, std::int32_t b) noexcept {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}

}  // namespace haptiv
