#include "scenegraph/nodes/SoHapticDevice.h"

#include "scenegraph/nodes/HapticNodes.h"

namespace haptiv {

SO_NODE_SOURCE(SoHapticDevice);

void SoHapticDevice::initClass() {
  HAPTIV_NODE_INIT_CLASS(SoHapticDevice, "HapticDevice", SoNode);
}

SoHapticDevice::SoHapticDevice() {
  SO_NODE_CONSTRUCTOR(SoHapticDevice);
  SO_NODE_ADD_FIELD(description, ("vishard10"));
  SO_NODE_ADD_FIELD(position, (SbVec3f(0.0F, 0.0F, 0.0F)));
  SO_NODE_ADD_FIELD(orientation, (SbRotation::identity()));
  SO_NODE_ADD_FIELD(scale, (1.0F));
}

SoHapticDevice::~SoHapticDevice() = default;

}  // namespace haptiv
