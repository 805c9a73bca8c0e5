#pragma once

#include <span>

#include "device/usb/spacemouse/SpaceMouseState.h"

namespace haptiv {

/// Takes one HID report of a SpaceMouse into its state. The first byte says what it tells, integers are little-endian:
///
///     1   x y z, 16 bits each; and in a report of 13 bytes or more the turns rx ry rz too, as the wireless ones have
///     it 2   rx ry rz 3   a bit a button, in 1 to 4 bytes or more
/// The length decides, not the model: one model has both layouts, by cable and by receiver. Any other report, and one
/// that is too short for what it says, is counted and changes nothing.
/// @param now  monotonic [ns]
/// Realtime-safe: yes.
void takeReport(std::span<const std::uint8_t> report, std::int64_t now, SpaceMouseState& state) noexcept;

}  // namespace haptiv
