#pragma once

#include <cstdint>

namespace haptiv {

/// Gaussian noise of zero mean and unit standard deviation, the same bits on every machine for a seed.
///
/// SplitMix64, and the sum of twelve 16-bit uniforms: a normal distribution cut off at six sigma. Not
/// std::normal_distribution, whose results differ from library to library.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : state_(seed) {}

  /// Realtime-safe: yes.
  double next() noexcept {
    std::int64_t sum = 0;
    for (int draw = 0; draw < 3; ++draw) {
      for (std::uint64_t bits = nextBits(), i = 0; i < 4; ++i, bits >>= 16)
        sum += static_cast<std::int64_t>(bits & 0xFFFF);
    }
    return static_cast<double>(sum - kMean) / 0x1p16;  // the variance of twelve is (2^32 - 1), nearly 2^32
  }

 private:
  static constexpr std::int64_t kMean = 6 * 0xFFFF;

  std::uint64_t nextBits() noexcept {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace haptiv
