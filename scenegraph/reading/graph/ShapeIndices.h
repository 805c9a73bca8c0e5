#pragma once

#include "scenegraph/Diagnostic.h"

namespace haptiv {

/// Shapes that reach beyond their coordinates, normals, materials or texture coordinates: Coin crashes on them when
/// they are drawn or visited, so a scene that has one is not to be shown. Where only a few normals, materials or
/// texture coordinates are missing, the last is repeated, and that is a warning. The graph must have passed
/// expansionFault. Looks behind every Switch and level of detail. The diagnostics have neither file nor line.
Diagnostics shapeIndexFaults(SoNode* root);

}  // namespace haptiv
