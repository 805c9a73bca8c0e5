#include "scenegraph/nodes/HapticNodes.h"

#include "scenegraph/nodes/SoHapticDevice.h"
#include "scenegraph/nodes/SoHapticNone.h"
#include "scenegraph/nodes/SoHapticPropertyElement.h"
#include "scenegraph/nodes/SoHapticRubberBand.h"
#include "scenegraph/nodes/SoHapticSpringZone.h"
#include "scenegraph/nodes/SoHapticSurface.h"
#include "scenegraph/nodes/SoHapticTool.h"
#include "scenegraph/nodes/SoHapticViscousZone.h"

namespace haptiv {

void initHapticNodes() {
  if (SoHapticProperty::getClassTypeId() != SoType::badType()) return;
  SoHapticPropertyElement::initClass();
  SoHapticProperty::initClass();
  SoHapticSurface::initClass();
  SoHapticViscousZone::initClass();
  SoHapticSpringZone::initClass();
  SoHapticRubberBand::initClass();
  SoHapticNone::initClass();
  SoHapticTool::initClass();
  SoHapticDevice::initClass();
}

}  // namespace haptiv
