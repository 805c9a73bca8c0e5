#pragma once

#include <Inventor/SbBox3f.h>
#include <Inventor/fields/SoSFFloat.h>

#include <string>
#include <vector>

#include "scenegraph/NodeRef.h"

namespace haptiv {

/// What Coin shows of the graph, in the scene's own unit; empty where it shows nothing.
SbBox3f modelBounds(SoNode* root);

/// Why no ball has a size that fits a model of these bounds, and what to do; empty where one has.
std::string solidFault(const SbBox3f& model);

/// A length of a sphere, cube, cylinder or cone that is below zero. Coin draws it as if it were above; a wall cannot
/// be.
struct NegativeSize {
  SoNode* node = nullptr;
  SoSFFloat* field = nullptr;
};
/// In the graph, also where a Switch hides them. Does not change it.
std::vector<NegativeSize> negativeSizes(SoNode* root);

}  // namespace haptiv
