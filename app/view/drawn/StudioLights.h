#pragma once

#include <Inventor/nodes/SoGroup.h>

namespace haptiv {

/// Ambient light and two lamps that leave no side black, for scenes that bring no light. Faces are lit
/// from both sides. Stands before what it lights.
SoGroup* makeStudioLights();

}  // namespace haptiv
