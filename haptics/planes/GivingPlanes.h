#pragma once

#include <span>

#include "device/types.h"
#include "haptics/planes/PlaneSet.h"

namespace haptiv {

/// Planes that push a point from the origin, normal . y >= missing, and give way: each pushes by the share s that it
/// gives way by d s, where the way y is the sum of all shares along the normals. It is the y of
///
///   min d |y|^2 / 2 + sum max(0, r_i - n_i . y)^2 / 2,   s_i = max(0, r_i - n_i . y) / d
///
/// for up to 32 planes. Realtime-safe: yes.
struct GivingPlanes {
  std::span<const Vector3> normal;  ///< unit
  std::span<const double> missing;  ///< r [m]
  std::span<double> share;          ///< out: s [m]
  double give;                      ///< d

  /// Which push, and where to.
  struct Settled {
    PlaneSet pushing = 0;
    Vector3 way = Vector3::Zero();
  };

  /// @param likely  which probably push, and where to; in closed form where that is nearly right and they are up to
  ///                three, else by Newton's method
  Settled settle(const Settled& likely) const noexcept;

 private:
  /// Whether just the guessed planes push. If they do not, the guess becomes a better one.
  bool settleAsGuessed(Settled& guess) const noexcept;
  template <std::size_t Size>
  bool settleAsGuessed(Settled& guess) const noexcept;
  Settled settleByNewton(const Vector3& guess) const noexcept;
  PlaneSet pushAt(const Vector3& y) const noexcept;
  double energyAt(const Vector3& y) const noexcept;
  Vector3 balance(PlaneSet planes) const noexcept;
};

}  // namespace haptiv
