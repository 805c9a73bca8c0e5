#pragma once

#include <Inventor/SbBox3f.h>
#include <Inventor/nodes/SoNode.h>

#include <vector>

namespace haptiv {

/// A box around each shape, in W: tighter together than one box around all. Thread: GUI.
std::vector<SbBox3f> shapeBoxes(SoNode* root);

}  // namespace haptiv
