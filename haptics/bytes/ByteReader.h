#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

#include "device/types.h"

namespace haptiv {

/// Reads what ByteWriter wrote; the bytes may be hostile. Throws std::runtime_error that says what is wrong at which
/// byte.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error("scene bytes, at byte " + std::to_string(at_) + ": " + what);
  }
  std::uint8_t u8() { return static_cast<std::uint8_t>(little(1)); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(little(4)); }
  double f64() {
    const double value = std::bit_cast<double>(little(8));
    if (!std::isfinite(value)) fail("a number that is not finite");
    return value;
  }
  double positive(const char* name) {
    const double value = f64();
    if (!(value > 0)) fail(std::string(name) + " must be greater than zero");
    return value;
  }
  template <typename Derived>
  void matrix(Eigen::MatrixBase<Derived>& values) {
    for (Eigen::Index column = 0; column < values.cols(); ++column) {
      for (Eigen::Index row = 0; row < values.rows(); ++row) values(row, column) = f64();
    }
  }
  /// A number of things of `size` bytes each, all of which must still be there.
  std::size_t count(std::size_t size) {
    const std::size_t wanted = u32();
    if (wanted > left() / size) fail("cut off: " + std::to_string(wanted) + " entries announced, too few bytes left");
    return wanted;
  }
  std::string text(std::size_t size) {
    require(size);
    std::string value(size, '\0');
    for (char& c : value) c = static_cast<char>(u8());
    return value;
  }
  std::size_t left() const { return bytes_.size() - at_; }

 private:
  void require(std::size_t size) const {
    if (size > left()) fail("cut off");
  }
  std::uint64_t little(int size) {
    require(static_cast<std::size_t>(size));
    std::uint64_t value = 0;
    for (int i = 0; i < size; ++i) value |= std::to_integer<std::uint64_t>(bytes_[at_++]) << (8 * i);
    return value;
  }
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
};

}  // namespace haptiv
