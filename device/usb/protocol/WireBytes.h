#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace haptiv::usb {

/// CRC-32 as of zlib, Ethernet and PNG (polynomial 0x04c11db7, reflected).
std::uint32_t crc32(std::span<const std::uint8_t> bytes) noexcept;

/// Puts little-endian integers one after the other into bytes that are known to suffice.
class WireWriter {
 public:
  explicit WireWriter(std::span<std::uint8_t> bytes) noexcept : bytes_(bytes) {}

  /// The lowest `size` bytes of a two's complement.
  void integer(std::int64_t value, int size) noexcept {
    for (int i = 0; i < size; ++i)
      bytes_[at_++] = static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> 8 * i);
  }
  /// The CRC of everything before it.
  void crc() noexcept { integer(crc32(bytes_.first(at_)), 4); }
  std::size_t size() const noexcept { return at_; }

 private:
  std::span<std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

/// Takes little-endian integers one after the other from bytes whose length has been checked.
class WireReader {
 public:
  explicit WireReader(std::span<const std::uint8_t> bytes) noexcept : bytes_(bytes) {}

  template <typename Integer>
  Integer unsignedInteger(int size = sizeof(Integer)) noexcept {
    std::uint64_t value = 0;
    for (int i = 0; i < size; ++i) value |= static_cast<std::uint64_t>(bytes_[at_++]) << 8 * i;
    return static_cast<Integer>(value);
  }
  template <typename Integer>
  Integer signedInteger(int size = sizeof(Integer)) noexcept {
    const auto raised = static_cast<std::int64_t>(unsignedInteger<std::uint64_t>(size) << (64 - 8 * size));
    return static_cast<Integer>(raised >> (64 - 8 * size));
  }
  void skip(std::size_t count) noexcept { at_ += count; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

}  // namespace haptiv::usb
