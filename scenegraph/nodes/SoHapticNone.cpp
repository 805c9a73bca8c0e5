#include "scenegraph/nodes/SoHapticNone.h"

#include "scenegraph/nodes/HapticNodes.h"

namespace haptiv {

SO_NODE_SOURCE(SoHapticNone);

void SoHapticNone::initClass() {
  HAPTIV_NODE_INIT_CLASS(SoHapticNone, "HapticNone", SoHapticProperty);
}

SoHapticNone::SoHapticNone() {
  SO_NODE_CONSTRUCTOR(SoHapticNone);
}

SoHapticNone::~SoHapticNone() = default;

bool SoHapticNone::isFelt() const {
  return false;
}

}  // namespace haptiv
