#pragma once

#include <array>
#include <cstdint>

namespace haptiv {

/// How a SpaceMouse's cap stands and what is pressed, as its reports say.
struct SpaceMouseState {
  bool connected = false;              ///< false: all else is at rest
  std::array<std::int16_t, 6> axes{};  ///< x right, y towards the user, z down; turns about them; some +-350 at most
  std::uint32_t buttons = 0;           ///< bit i: button i + 1
  std::uint32_t reports = 0;           ///< that were understood
  std::uint32_t ignored = 0;           ///< that were not: too short, or of a kind that tells neither axes nor buttons
  std::int64_t time = 0;               ///< of the last one that told axes [ns], by the caller's clock

  bool operator==(const SpaceMouseState&) const = default;
};

}  // namespace haptiv
