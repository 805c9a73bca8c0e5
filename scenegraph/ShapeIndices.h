#pragma once

#include "scenegraph/Diagnostic.h"

namespace haptiv {

/// Shapes that point beyond their coordinates: Coin crashes on them when they are drawn or visited, so a scene that has
/// one is not to be shown. The graph must have no cycles. Looks behind every Switch and level of detail.
Diagnostics shapeIndexFaults(SoNode* root);

}  // namespace haptiv
