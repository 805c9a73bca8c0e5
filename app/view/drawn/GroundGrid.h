#pragma once

#include <Inventor/nodes/SoSeparator.h>

namespace haptiv {

/// Lines 5 cm apart on the floor, every second one stronger, fading out 1 m from the origin. For looking at only: it
/// cannot be picked, and lies a hair below z = 0 so that floors of scenes cover it.
SoSeparator* makeGroundGrid();

}  // namespace haptiv
