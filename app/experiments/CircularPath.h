#pragma once

#include "device/types.h"

namespace haptiv {

/// A circle in a horizontal plane at constant speed, clockwise seen from +z; the orientation is kept. In B.
/// It starts where x is greatest.
struct CircularPath {
  Vector3 centre = Vector3::Zero();        ///< [m]
  double radius = 0.4;                     ///< [m], > 0
  double speed = 1;                        ///< [m/s], > 0
  Matrix3 rotation = Matrix3::Identity();  ///< R_BT, kept

  /// X_BT after t [s].
  Pose at(double t) const;
  /// How far along the circle [rad], growing; two turns are 4 pi.
  double angle(double t) const { return speed * t / radius; }
  /// How long `turns` of it take [s].
  double duration(double turns) const;
};

}  // namespace haptiv
