#pragma once

#include <Inventor/SbMatrix.h>

#include <optional>
#include <string>

#include "haptics/scene/HapticScene.h"

class SoNode;

namespace haptiv {

/// What became of a shape under a transform.
struct ConvertedShape {
  std::optional<Shape> shape;  ///< one of the exact kinds; nothing: it is to be felt by its triangles
  std::string fault;           ///< a size that cannot be; empty: none
};

/// A Cube, Sphere, Cylinder or Cone, of Inventor or VRML 97, that its transform leaves what it is. A sphere that
/// becomes an ellipsoid, a cylinder that becomes oval or skew, one of which a part is left out, and what has no volume
/// are felt by their triangles, as is everything else.
/// @param modelMatrix  from the node's coordinates to W, Coin's way (row vectors)
ConvertedShape convertShape(const SoNode* node, const SbMatrix& modelMatrix);

/// A point through Coin's matrix, in double precision.
Vector3 transformPoint(const SbMatrix& matrix, const Vector3& point);

}  // namespace haptiv
