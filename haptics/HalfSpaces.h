#pragma once

#include <algorithm>
#include <array>

#include "device/types.h"

namespace haptiv {

/// Half spaces normal . x >= offset, in W, in which a point may be.
template <int Capacity>
struct HalfSpaces {
  std::array<Vector3, Capacity> normal;  ///< unit
  std::array<double, Capacity> offset;   ///< [m]
  std::array<double, Capacity> share;    ///< out: of the way back to them, along the normal, >= 0 [m]
  int count = 0;

  void add(const Vector3& unitNormal, double newOffset) noexcept {
    normal[static_cast<std::size_t>(count)] = unitNormal;
    offset[static_cast<std::size_t>(count++)] = newOffset;
  }

  /// Nearest point to p that is in all of them: p + sum of share * normal (Hildreth's row-action method).
  ///
  /// Exact for one plane and for orthogonal ones, geometrically convergent for others. Where no point is in all of
  /// them (a gap narrower than the ball) the result is some point between. Realtime-safe: yes.
  Vector3 nearest(const Vector3& p) noexcept {
    std::fill_n(share.begin(), count, 0.0);
    Vector3 x = p;
    for (int pass = 0; pass < kPasses; ++pass) {
      double moved = 0;
      double total = 0;
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const double wanted = share[i] + offset[i] - normal[i].dot(x);
        const double next = wanted > 0 ? wanted : 0;
        x += (next - share[i]) * normal[i];
        moved += next > share[i] ? next - share[i] : share[i] - next;
        total += next;
        share[i] = next;
      }
      if (!(moved > kSettled * total)) break;
    }
    return x;
  }

 private:
  static constexpr int kPasses = 100;       ///< settles corners down to some 20 degrees
  static constexpr double kSettled = 1e-9;  ///< of the whole way
};

}  // namespace haptiv
