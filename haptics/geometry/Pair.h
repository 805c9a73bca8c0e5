#pragma once

#include <cmath>
#include <cstdint>

namespace haptiv {

/// Two numbers that are reckoned side by side. Realtime-safe: yes, all of this.
using Pair = double __attribute__((vector_size(16)));
/// Of each number all bits or none: what a comparison of pairs gives.
using PairMask = decltype(Pair{} < Pair{});

inline Pair twice(double x) noexcept {
  return Pair{x, x};
}
inline PairMask bitsOf(const Pair& x) noexcept {
  return (PairMask)x;
}

inline Pair larger(const Pair& a, const Pair& b) noexcept {
  return a > b ? a : b;
}
inline Pair squareRoot(const Pair& x) noexcept {
  return Pair{std::sqrt(x[0]), std::sqrt(x[1])};
}
inline Pair absolute(const Pair& x) noexcept {
  return (Pair)(bitsOf(x) & ~bitsOf(twice(-0.0)));
}
/// As large as one, with the sign of the other. @param size  not negative
inline Pair withSign(const Pair& size, const Pair& sign) noexcept {
  return (Pair)(bitsOf(size) | (bitsOf(sign) & bitsOf(twice(-0.0))));
}
/// The one where the mask is set, else the other.
inline PairMask chosen(const PairMask& mask, const PairMask& one, const PairMask& other) noexcept {
  return (mask & one) | (~mask & other);
}
/// One where there is a minus sign, else none.
inline PairMask isNegative(const PairMask& bits) noexcept {
  using Unsigned = std::uint64_t __attribute__((vector_size(16)));
  return (PairMask)((Unsigned)bits >> 63);
}

/// The first number of each.
inline Pair firstOf(const Pair& a, const Pair& b) noexcept {
  return __builtin_shufflevector(a, b, 0, 2);
}
inline Pair secondOf(const Pair& a, const Pair& b) noexcept {
  return __builtin_shufflevector(a, b, 1, 3);
}

}  // namespace haptiv
