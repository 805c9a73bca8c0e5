#include "scenegraph/nodes/SoHapticViscousZone.h"

#include "scenegraph/nodes/HapticNodes.h"

namespace haptiv {

SO_NODE_SOURCE(SoHapticViscousZone);

void SoHapticViscousZone::initClass() {
  HAPTIV_NODE_INIT_CLASS(SoHapticViscousZone, "HapticViscousZone", SoHapticProperty);
}

SoHapticViscousZone::SoHapticViscousZone() {
  SO_NODE_CONSTRUCTOR(SoHapticViscousZone);
  SO_NODE_ADD_FIELD(damping, (15.0F));
  SO_NODE_ADD_FIELD(enabled, (TRUE));
  SO_NODE_ADD_FIELD(label, (""));
}

SoHapticViscousZone::~SoHapticViscousZone() = default;

bool SoHapticViscousZone::isFelt() const {
  return enabled.getValue() != FALSE;
}

}  // namespace haptiv
