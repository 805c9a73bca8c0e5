#pragma once

#include "device/board/BoardSignals.h"
#include "device/usb/protocol/FrameHead.h"

namespace haptiv::usb {

/// High speed: one full frame each microframe interval. Full speed: 64 bytes each millisecond, hence the packed form.
enum class FrameForm : std::uint8_t { full, packed };

inline constexpr std::size_t kStateSize = 104;
inline constexpr std::size_t kCommandSize = 60;
inline constexpr std::size_t kPackedStateSize = 64;
inline constexpr std::size_t kPackedCommandSize = 44;
inline constexpr std::size_t kLargestFrame = kStateSize;

constexpr std::size_t stateSize(FrameForm form) {
  return form == FrameForm::full ? kStateSize : kPackedStateSize;
}
constexpr std::size_t commandSize(FrameForm form) {
  return form == FrameForm::full ? kCommandSize : kPackedCommandSize;
}

/// What the board sends, again and again.
struct StateFrame {
  std::uint32_t sequence = 0;  ///< grows by one with every frame
  BoardReport report;          ///< of the counters, damaged, outOfOrder, notFinite and clamped; none in the packed form
};

/// All of these are total, of constant time, and realtime-safe. docs/usb-protocol.md has the byte tables.
///
/// The packed form leaves the upper bits of counts, times and sequence numbers out: decoding takes those nearest to the
/// frame or command before. What is not on the wire is zero.

/// Writes a frame to the first bytes of `out`; returns them.
std::span<const std::uint8_t> encodeState(const StateFrame& state, FrameForm form,
                                          std::span<std::uint8_t, kLargestFrame> out) noexcept;
/// Set-points are rounded to the unit of the wire and cut to its range; those that are no numbers stay so.
std::span<const std::uint8_t> encodeCommand(const BoardCommand& command, FrameForm form,
                                            std::span<std::uint8_t, kLargestFrame> out) noexcept;

/// `state` is changed only by a whole frame; it goes in as the frame before.
FrameFault decodeState(std::span<const std::uint8_t> bytes, FrameForm form, StateFrame& state) noexcept;
/// `command` is changed only by a whole frame; it goes in as the command before.
FrameFault decodeCommand(std::span<const std::uint8_t> bytes, FrameForm form, BoardCommand& command) noexcept;

}  // namespace haptiv::usb
