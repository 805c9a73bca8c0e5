#pragma once

#include <string>

#include "haptics/HapticScene.h"

namespace haptiv {

/// Upright box walls as the text of a scene: each with a surface, a translation and a cube of its own.
std::string sceneText(const HapticScene& scene);

}  // namespace haptiv
