#include "scenegraph/nodes/SoHapticSurface.h"

#include "scenegraph/nodes/HapticNodes.h"

namespace haptiv {

SO_NODE_SOURCE(SoHapticSurface);

void SoHapticSurface::initClass() {
  HAPTIV_NODE_INIT_CLASS(SoHapticSurface, "HapticSurface", SoHapticProperty);
}

SoHapticSurface::SoHapticSurface() {
  SO_NODE_CONSTRUCTOR(SoHapticSurface);
  SO_NODE_ADD_FIELD(stiffness, (2000.0F));
  SO_NODE_ADD_FIELD(damping, (20.0F));
  SO_NODE_ADD_FIELD(hysteresis, (0.0F));
  SO_NODE_ADD_FIELD(staticFriction, (0.0F));
  SO_NODE_ADD_FIELD(dynamicFriction, (0.0F));
  SO_NODE_ADD_FIELD(enabled, (TRUE));
  SO_NODE_ADD_FIELD(label, (""));
}

SoHapticSurface::~SoHapticSurface() = default;

bool SoHapticSurface::isFelt() const {
  return enabled.getValue() != FALSE;
}

}  // namespace haptiv
