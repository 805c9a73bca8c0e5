#pragma once

#include <array>
#include <cstddef>

#include "device/types.h"

namespace haptiv {

/// One, two or three planes that all push a point, each giving way by the `give`-th part of what it does: how much each
/// does, in closed form.
///
/// With their unit normals as columns of N, and asked for r: s = (N^T N + give I)^-1 r, which falls short of r by
/// give s; and better, s' = (N^T N + give I)^-1 (r + give s). Realtime-safe: yes.
template <std::size_t Size>
class PushingPlanes {
  static_assert(Size >= 1 && Size <= 3);

 public:
  using Each = std::array<double, Size>;
  using Normals = std::array<Vector3, Size>;

  PushingPlanes(const Normals& n, double give) noexcept {
    const double one = 1 + give;
    if constexpr (Size == 1) {
      once_ = {1 / one};
    } else if constexpr (Size == 2) {
      cosine_ = {n[0].dot(n[1])};
      const double scale = 1 / (one * one - cosine_[0] * cosine_[0]);
      once_ = {one * scale, one * scale, -cosine_[0] * scale};
    } else {
      cosine_ = {n[0].dot(n[1]), n[0].dot(n[2]), n[1].dot(n[2])};
      const auto [c, b, a] = cosine_;
      const double aa = one * one - a * a, ab = a * b - one * c, ac = a * c - one * b;
      const double scale = 1 / (one * aa + c * ab + b * ac);
      once_ = {aa * scale, (one * one - b * b) * scale, (one * one - c * c) * scale, ab * scale,
               ac * scale, (b * c - one * a) * scale};
    }
    const Symmetric square = squareOf(once_);
    for (std::size_t k = 0; k < square.size(); ++k) twice_[k] = once_[k] + give * square[k];
  }

  /// s
  Each roughShares(const Each& r) const noexcept { return times(once_, r); }
  /// s'
  Each shares(const Each& r) const noexcept { return times(twice_, r); }

  /// |N s|^2 and |s|^2
  struct Squares {
    double way, shares;
  };
  Squares squaresOf(const Each& s) const noexcept {
    double shares = s[0] * s[0], mixed = 0;
    for (std::size_t k = 1; k < Size; ++k) {
      shares += s[k] * s[k];
      mixed += cosine_[k - 1] * s[0] * s[k];
    }
    if constexpr (Size == 3) mixed += cosine_[2] * s[1] * s[2];
    return {shares + 2 * mixed, shares};
  }

 private:
  using Symmetric = std::array<double, Size*(Size + 1) / 2>;  ///< the diagonal; then (0, 1), (0, 2), (1, 2)

  static Each times(const Symmetric& m, const Each& r) noexcept {
    if constexpr (Size == 1) return {m[0] * r[0]};
    if constexpr (Size == 2) return {m[0] * r[0] + m[2] * r[1], m[2] * r[0] + m[1] * r[1]};
    if constexpr (Size == 3) {
      return {m[0] * r[0] + m[3] * r[1] + m[4] * r[2], m[3] * r[0] + m[1] * r[1] + m[5] * r[2],
              m[4] * r[0] + m[5] * r[1] + m[2] * r[2]};
    }
  }
  static Symmetric squareOf(const Symmetric& m) noexcept {
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

  std::array<double, Size*(Size - 1) / 2> cosine_;  ///< of the angles between the normals: (0, 1), (0, 2), (1, 2)
  Symmetric once_, twice_;                          ///< what makes s and s' of r
};

}  // namespace haptiv
