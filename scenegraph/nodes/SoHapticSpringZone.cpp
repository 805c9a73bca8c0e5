#include "scenegraph/nodes/SoHapticSpringZone.h"

#include "scenegraph/nodes/HapticNodes.h"

namespace haptiv {

SO_NODE_SOURCE(SoHapticSpringZone);

void SoHapticSpringZone::initClass() {
  HAPTIV_NODE_INIT_CLASS(SoHapticSpringZone, "HapticSpringZone", SoHapticProperty);
}

SoHapticSpringZone::SoHapticSpringZone() {
  SO_NODE_CONSTRUCTOR(SoHapticSpringZone);
  SO_NODE_ADD_FIELD(stiffness, (150.0F));
  SO_NODE_ADD_FIELD(anchor, (SbVec3f(0.0F, 0.0F, 0.0F)));
  SO_NODE_ADD_FIELD(restLength, (0.0F));
  SO_NODE_ADD_FIELD(enabled, (TRUE));
  SO_NODE_ADD_FIELD(label, (""));
}

SoHapticSpringZone::~SoHapticSpringZone() = default;

bool SoHapticSpringZone::isFelt() const {
  return enabled.getValue() != FALSE;
}

}  // namespace haptiv
