#include "scenegraph/nodes/SoHapticRubberBand.h"

#include "scenegraph/nodes/HapticNodes.h"

namespace haptiv {

SO_NODE_SOURCE(SoHapticRubberBand);

void SoHapticRubberBand::initClass() {
  HAPTIV_NODE_INIT_CLASS(SoHapticRubberBand, "HapticRubberBand", SoHapticSpringZone);
}

SoHapticRubberBand::SoHapticRubberBand() {
  SO_NODE_CONSTRUCTOR(SoHapticRubberBand);
}

SoHapticRubberBand::~SoHapticRubberBand() = default;

}  // namespace haptiv
