#pragma once

#include <string>

#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// Tool, device and upright box walls as the text of a scene: each wall with a surface, a translation and a cube of its
/// own.
std::string sceneText(const HapticScene& scene);

}  // namespace haptiv
