#pragma once

#include <Inventor/SbMatrix.h>
#include <Inventor/SbName.h>

#include <vector>

#include "haptics/meshes/TriangleMesh.h"

class SoCallbackAction;
class SoNode;

namespace haptiv {

/// All that a shape's triangles in W depend on. Equal sources give equal triangles.
///
/// Coin gives a node a new number whenever it, or a node below it, is changed: numbers stand for contents.
struct MeshSource {
  /// Of the shape that the action is at.
  static MeshSource of(const SoNode* shape, const SoCallbackAction& action);

  bool operator==(const MeshSource&) const = default;

  SbMatrix toW;                   ///< from the shape's coordinates, Coin's way (row vectors)
  bool isClockwise = false;       ///< corners come clockwise, seen from outside
  std::vector<SbUniqueId> nodes;  ///< the shape, its coordinates, and the profiles of texts and NURBS
  SbName font;
  float fontSize = 0;
  float complexity = 0;
  int complexityType = 0;
  int faceType = 0;
};

}  // namespace haptiv
