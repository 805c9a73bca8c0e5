#include "device/usb/protocol/FrameHead.h"

#include <zlib.h>

namespace haptiv::usb {

std::uint32_t crc32(std::span<const std::uint8_t> bytes) noexcept {
  return static_cast<std::uint32_t>(::crc32_z(0, bytes.data(), bytes.size()));
}

void writeHead(WireWriter& out, FrameType type) noexcept {
  out.integer(kMagic, 2);
  out.integer(kProtocolVersion, 1);
  out.integer(static_cast<std::uint8_t>(type), 1);
}

FrameFault checkFrame(std::span<const std::uint8_t> bytes, FrameType type, std::size_t size) noexcept {
  if (bytes.size() < kHeadSize + kCrcSize) return FrameFault::length;
  WireReader in(bytes);
  if (in.unsignedInteger<std::uint16_t>() != kMagic) return FrameFault::magic;
  if (in.unsignedInteger<std::uint8_t>() != kProtocolVersion) return FrameFault::version;
  if (in.unsignedInteger<std::uint8_t>() != static_cast<std::uint8_t>(type)) return FrameFault::type;
  if (bytes.size() != size) return FrameFault::length;
  WireReader end(bytes.last(kCrcSize));
  if (end.unsignedInteger<std::uint32_t>() != crc32(bytes.first(size - kCrcSize))) return FrameFault::crc;
  return FrameFault::none;
}

const char* describe(FrameFault fault) noexcept {
  switch (fault) {
    case FrameFault::none:
      return "whole";
    case FrameFault::length:
      return "of a wrong length";
    case FrameFault::magic:
      return "no frame of the protocol";
    case FrameFault::version:
      return "of another version of the protocol";
    case FrameFault::type:
      return "of another type than expected";
    case FrameFault::crc:
      return "damaged: its CRC is wrong";
    case FrameFault::content:
      return "of a content that cannot be";
  }
  return "unknown";
}

}  // namespace haptiv::usb
