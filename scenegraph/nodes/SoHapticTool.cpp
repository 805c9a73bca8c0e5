#include "scenegraph/nodes/SoHapticTool.h"

#include "scenegraph/nodes/HapticNodes.h"

namespace haptiv {

SO_NODE_SOURCE(SoHapticTool);

void SoHapticTool::initClass() {
  HAPTIV_NODE_INIT_CLASS(SoHapticTool, "HapticTool", SoNode);
}

SoHapticTool::SoHapticTool() {
  SO_NODE_CONSTRUCTOR(SoHapticTool);
  SO_NODE_ADD_FIELD(mass, (2.0F));
  SO_NODE_ADD_FIELD(damping, (5.0F));
  SO_NODE_ADD_FIELD(radius, (0.01F));
  SO_NODE_ADD_FIELD(home, (SbVec3f(0.0F, 0.0F, 0.0F)));
}

SoHapticTool::~SoHapticTool() = default;

}  // namespace haptiv
