#pragma once

#include <Inventor/SbMatrix.h>

#include <optional>
#include <string>

#include "haptics/HapticScene.h"

class SoNode;

namespace haptiv {

/// What became of a Cube, Sphere, Cylinder or Cone under a transform.
struct ConvertedShape {
  std::optional<Shape> shape;
  bool isError = false;  ///< `remark` is an error: a size that cannot be
  std::string remark;    ///< why there is no shape, or in what it differs; empty where all is well
};

/// Whether a node is one of the four shapes that are felt exactly.
bool isExactShape(const SoNode* node);

/// @param modelMatrix  from the node's coordinates to W, Coin's way (row vectors)
ConvertedShape convertShape(const SoNode* node, const SbMatrix& modelMatrix);

/// A point through Coin's matrix, in double precision.
Vector3 transformPoint(const SbMatrix& matrix, const Vector3& point);

}  // namespace haptiv
