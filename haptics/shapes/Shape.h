#pragma once

#include <cstdint>
#include <memory>

#include "device/types.h"
#include "haptics/meshes/TriangleMesh.h"

namespace haptiv {

/// An exact shape in the scene. Its local frame S has its origin in the shape's centre.
///
///   box       |a_i . s| <= 1 along three axes: `axes` holds the half edges as columns, which may be skewed
///   sphere    radius = |axes.col(0)|; the columns are orthogonal and of equal length
///   cylinder  axis and half height = axes.col(1), radius = |axes.col(0)|; orthogonal columns, 0 and 2 of equal length
///   cone      as the cylinder, base at -axes.col(1), apex at +axes.col(1)
/// (the local axes of Open Inventor's Cube, Sphere, Cylinder and Cone)
///   mesh      triangles, in W; centre and axes are those of the box around them. A closed one is solid
struct Shape {
  enum class Kind : std::uint8_t { box, sphere, cylinder, cone, mesh };
  Kind kind = Kind::box;
  Vector3 centre = Vector3::Zero();          ///< p_WS [m]
  Matrix3 axes = Matrix3::Identity();        ///< half extents in W, as columns [m]
  std::shared_ptr<const TriangleMesh> mesh;  ///< for Kind::mesh alone; shared by the versions of an edited scene
};

}  // namespace haptiv
