#pragma once

#include <Inventor/SbRotation.h>
#include <Inventor/SbVec3f.h>

#include <Eigen/Geometry>

#include "device/types.h"

namespace haptiv {

inline Vector3 toEigen(const SbVec3f& v) {
  return Vector3(v[0], v[1], v[2]);
}

/// The rotation's matrix; of unit length whatever the rotation's own.
inline Matrix3 toEigen(const SbRotation& rotation) {
  const float* q = rotation.getValue();  // x, y, z, w
  return Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized().toRotationMatrix();
}

}  // namespace haptiv
