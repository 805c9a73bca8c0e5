#pragma once

#include <vector>

class SoNode;

namespace haptiv {

/// The nodes that a wall or zone came from; never dereferenced after the graph has changed.
struct ShapeOrigin {
  const SoNode* shape = nullptr;
  const SoNode* property = nullptr;
};

/// Where everything in a compiled scene came from.
struct SceneOrigins {
  std::vector<ShapeOrigin> walls;         ///< one each, in the order of HapticScene::walls
  std::vector<ShapeOrigin> zones;         ///< one each, in the order of HapticScene::zones
  std::vector<const SoNode*> properties;  ///< every haptic property met, once, in the order of the text
  const SoNode* tool = nullptr;           ///< null where the scene has none
  const SoNode* device = nullptr;         ///< null: the defaults are in force
};

}  // namespace haptiv
