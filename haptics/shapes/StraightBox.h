#pragma once

#include "device/types.h"

namespace haptiv {

/// A box with right angles and a volume, ready to be measured from a point without a division.
struct StraightBox {
  static constexpr double kOutside = 1e-150;  ///< a distance whose square is still a number [m]

  Vector3 centre = Vector3::Zero();       ///< p_WS [m]
  Matrix3 normals = Matrix3::Identity();  ///< unit outward normals of the faces at +a_i, in W, as rows
  Vector3 half = Vector3::Zero();         ///< half edges [m]
};

/// Its edges lie along the axes of W, and are named as these.
inline bool isUpright(const StraightBox& box) noexcept {
  return box.normals == Matrix3::Identity();
}

}  // namespace haptiv
