#pragma once

#include <Inventor/nodes/SoGroup.h>

namespace haptiv {

/// Ambient light and two lamps that leave no side black, for scenes that bring no light. Stands before what it lights.
SoGroup* makeStudioLights();

}  // namespace haptiv
