#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "device/types.h"

namespace haptiv {

/// Numbers as little-endian bytes, doubles bit for bit.
class ByteWriter {
 public:
  void u8(std::uint8_t value) { bytes_.push_back(std::byte{value}); }
  void u32(std::uint32_t value) { little<4>(value); }
  void f64(double value) { little<8>(std::bit_cast<std::uint64_t>(value)); }
  template <typename Derived>
  void matrix(const Eigen::MatrixBase<Derived>& values) {
    for (Eigen::Index column = 0; column < values.cols(); ++column) {
      for (Eigen::Index row = 0; row < values.rows(); ++row) f64(values(row, column));
    }
  }
  void text(std::string_view value) {
    for (const char c : value) u8(static_cast<std::uint8_t>(c));
  }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  template <int kSize>
  void little(std::uint64_t value) {
    std::byte bytes[kSize];
    for (int i = 0; i < kSize; ++i) bytes[i] = static_cast<std::byte>(value >> (8 * i));
    bytes_.insert(bytes_.end(), bytes, bytes + kSize);
  }
  std::vector<std::byte> bytes_;
};

}  // namespace haptiv
