#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace haptiv::usbip {

using Bytes = std::vector<std::uint8_t>;

/// Appends big-endian integers, as USB/IP has them.
class NetworkWriter {
 public:
  explicit NetworkWriter(Bytes& out) : out_(out) {}

  void integer(std::uint32_t value, int size) {
    for (int i = size - 1; i >= 0; --i) out_.push_back(static_cast<std::uint8_t>(value >> 8 * i));
  }
  void bytes(std::span<const std::uint8_t> bytes) { out_.insert(out_.end(), bytes.begin(), bytes.end()); }
  void zeros(std::size_t count) { out_.insert(out_.end(), count, 0); }
  /// Text in a field of so many bytes, filled up with zeros.
  void text(std::string_view text, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) out_.push_back(static_cast<std::uint8_t>(i < text.size() ? text[i] : 0));
  }

 private:
  Bytes& out_;
};

/// Takes big-endian integers one after the other from bytes whose length has been checked.
class NetworkReader {
 public:
  explicit NetworkReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint32_t integer(int size) {
    std::uint32_t value = 0;
    for (int i = 0; i < size; ++i) value = value << 8 | bytes_[at_++];
    return value;
  }
  std::span<const std::uint8_t> bytes(std::size_t count) {
    at_ += count;
    return bytes_.subspan(at_ - count, count);
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

}  // namespace haptiv::usbip
