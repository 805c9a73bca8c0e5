#pragma once

#include <array>
#include <cstddef>

#include "device/types.h"
#include "haptics/geometry/Pair.h"

namespace haptiv {

/// One, two or three planes that all push a point, in closed form: side by side as they give way, each by the `give`-th
/// part of what it does, and firm.
///
/// With their unit normals as columns of N, and asked for r: s = (N^T N + give I)^-1 r, which falls short of r by
/// give s; s' = (N^T N + give I)^-1 (r + give s), which falls short by less; and the firm (N^T N)^-1 r, which does not,
/// but is lost in rounding where planes are nearly parallel. Realtime-safe: yes.
template <std::size_t Size>
class PushingPlanes {
  static_assert(Size >= 1 && Size <= 3);

 public:
  using Each = std::array<double, Size>;
  using Both = std::array<Pair, Size>;  ///< of each plane the share as it gives way, and the firm one
  using Normals = std::array<Vector3, Size>;

  PushingPlanes(const Normals& n, double give) noexcept {
    const Pair one = {1 + give, 1};
    if constexpr (Size == 1) {
      once_ = {1 / one};
    } else if constexpr (Size == 2) {
      const Pair c = twice(n[0].dot(n[1])), determinant = one * one - c * c, scale = 1 / determinant;
      once_ = {one * scale, one * scale, -c * scale};
      spread_ = determinant[1];
    } else {
      const Pair c = twice(n[0].dot(n[1])), b = twice(n[0].dot(n[2])), a = twice(n[1].dot(n[2]));
      const Pair aa = one * one - a * a, ab = a * b - one * c, ac = a * c - one * b;
      const Pair determinant = one * aa + c * ab + b * ac, scale = 1 / determinant;
      once_ = {aa * scale, (one * one - b * b) * scale, (one * one - c * c) * scale, ab * scale,
               ac * scale, (b * c - one * a) * scale};
      spread_ = determinant[1];
    }
    Symmetric<double> once;
    for (std::size_t k = 0; k < once.size(); ++k) once[k] = once_[k][0];
    const Symmetric<double> square = squareOf(once);
    for (std::size_t k = 0; k < square.size(); ++k) twice_[k] = once[k] + give * square[k];
  }

  /// s, and the firm ones
  Both shares(const Each& r) const noexcept {
    Both asked;
    for (std::size_t k = 0; k < Size; ++k) asked[k] = haptiv::twice(r[k]);
    return times(once_, asked);
  }
  /// s'
  Each nearerShares(const Each& r) const noexcept { return times(twice_, r); }

  /// How far the planes are from being parallel: the square of their angle's sine, or of the volume of their normals.
  double spread() const noexcept { return spread_; }

 private:
  /// The diagonal; then (0, 1), (0, 2), (1, 2)
  template <typename Number>
  using Symmetric = std::array<Number, Size*(Size + 1) / 2>;

  template <typename Number>
  static std::array<Number, Size> times(const Symmetric<Number>& m, const std::array<Number, Size>& r) noexcept {
    if constexpr (Size == 1) return {m[0] * r[0]};
    if constexpr (Size == 2) return {m[0] * r[0] + m[2] * r[1], m[2] * r[0] + m[1] * r[1]};
    if constexpr (Size == 3) {
      return {m[0] * r[0] + m[3] * r[1] + m[4] * r[2], m[3] * r[0] + m[1] * r[1] + m[5] * r[2],
              m[4] * r[0] + m[5] * r[1] + m[2] * r[2]};
    }
  }
  static Symmetric<double> squareOf(const Symmetric<double>& m) noexcept {
    if constexpr (Size == 1) return {m[0] * m[0]};
    if constexpr (Size == 2) {
      return {m[0] * m[0] + m[2] * m[2], m[1] * m[1] + m[2] * m[2], m[2] * (m[0] + m[1])};
    }
    if constexpr (Size == 3) {
      const double d = m[3] * m[3], e = m[4] * m[4], f = m[5] * m[5];
      return {m[0] * m[0] + d + e,
              m[1] * m[1] + d + f,
              m[2] * m[2] + e + f,
              m[3] * (m[0] + m[1]) + m[4] * m[5],
              m[4] * (m[0] + m[2]) + m[3] * m[5],
              m[5] * (m[1] + m[2]) + m[3] * m[4]};
    }
  }

  Symmetric<Pair> once_;     ///< what makes s, and the firm ones, of r
  Symmetric<double> twice_;  ///< what makes s' of r
  double spread_ = 1;
};

}  // namespace haptiv
