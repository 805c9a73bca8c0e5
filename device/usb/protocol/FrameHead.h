#pragma once

#include <cstdint>
#include <span>

#include "device/usb/protocol/WireBytes.h"

namespace haptiv::usb {

inline constexpr std::uint16_t kMagic = 0x5648;  ///< "HV" on the wire
inline constexpr std::uint8_t kProtocolVersion = 1;

/// The byte that says what a frame is; the packed forms are those of full speed.
enum class FrameType : std::uint8_t {
  state = 0x01,
  command = 0x02,
  packedState = 0x11,
  packedCommand = 0x12,
  identity = 0x21,
  capabilities = 0x22,
  thresholds = 0x23,
  home = 0x24,
};

/// What is wrong with a frame.
enum class FrameFault : std::uint8_t { none, length, magic, version, type, crc, content };

inline constexpr std::size_t kHeadSize = 4;
inline constexpr std::size_t kCrcSize = 4;

/// Magic, version and type.
void writeHead(WireWriter& out, FrameType type) noexcept;

/// Whether a frame is whole: as long as wanted, with the right head, and its last four bytes the CRC of the others. The
/// first fault found, in the order of FrameFault. Total: never reads beyond the bytes.
FrameFault checkFrame(std::span<const std::uint8_t> bytes, FrameType type, std::size_t size) noexcept;

/// In words, for the operator.
const char* describe(FrameFault fault) noexcept;

}  // namespace haptiv::usb
