#pragma once

#include <string>

#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// What of a scene's numbers cannot be felt, nor read back from a log: "the stiffness of the wall with id 3 is no
/// finite number", "the mass of the tool is not greater than zero". Empty where all can. The compiler makes no such
/// scene.
std::string wrongNumberIn(const HapticScene& scene);

}  // namespace haptiv
