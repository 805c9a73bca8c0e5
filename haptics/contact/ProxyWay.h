#pragma once

#include <algorithm>
#include <limits>

#include "haptics/geometry/Bounds.h"

namespace haptiv {

/// All that is no farther than `reach` from a straight way.
struct ProxyWay {
  Vector3 middle = Vector3::Zero();  ///< in W [m]
  Vector3 half = Vector3::Zero();    ///< the step from there to the end [m]
  double reach = 0;                  ///< [m]

  /// Around the way itself: what is within `reach` of the way is within it of this box.
  Bounds box() const noexcept { return {middle - half.cwiseAbs(), middle + half.cwiseAbs()}; }

  /// The ball around the middle that holds all of it.
  double farthest() const noexcept { return reach + half.norm(); }

  /// How far away from a place all is within it; negative where the place is not [m].
  double roomAt(const Vector3& p_W) const noexcept {
    const Vector3 gone = p_W - middle;
    const double squared = std::max(half.squaredNorm(), std::numeric_limits<double>::min());
    const double at = std::clamp(gone.dot(half) / squared, -1.0, 1.0);
    return reach - (gone - at * half).norm();
  }
  bool holds(const Vector3& p_W, double within) const noexcept { return within <= (1 - 1e-9) * roomAt(p_W); }
};

}  // namespace haptiv
