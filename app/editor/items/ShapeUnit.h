#pragma once

#include <Inventor/SoPath.h>

namespace haptiv {

/// Whether the shape at the end of the path stands in a Separator that holds no other shape: then what precedes it
/// there acts on this shape only.
bool standsAlone(const SoPath& path);

/// How many nodes to go up from the shape to what belongs to this shape alone: 1 for the Separator that holds it
/// together with its properties, 0 for the bare shape. It is what a user means by deleting the shape.
int depthOfUnit(const SoPath& path);

}  // namespace haptiv
