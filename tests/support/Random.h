#pragma once

#include <cstdint>
#include <numbers>
#include <random>

#include "device/types.h"

namespace haptiv::test {

/// Seeded random values: the same ones in every run and with every library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Evenly spread over [low, high).
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }

  /// Every entry evenly spread over [low, high).
  template <typename Vector>
  Vector vector(double low, double high) {
    Vector v;
    for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = between(low, high);
    return v;
  }

 private:
  std::mt19937_64 engine_;
};

/// Every joint anywhere within a turn.
inline JointVector randomAngles(Random& random) {
  return random.vector<JointVector>(-std::numbers::pi, std::numbers::pi);
}

}  // namespace haptiv::test
