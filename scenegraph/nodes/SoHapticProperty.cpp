#include "scenegraph/nodes/SoHapticProperty.h"

#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/actions/SoPickAction.h>

#include "scenegraph/nodes/HapticNodes.h"
#include "scenegraph/nodes/SoHapticPropertyElement.h"

namespace haptiv {

SO_NODE_ABSTRACT_SOURCE(SoHapticProperty);

void SoHapticProperty::initClass() {
  SO_NODE_INIT_ABSTRACT_CLASS(SoHapticProperty, SoNode, "Node");
  SO_ENABLE(SoCallbackAction, SoHapticPropertyElement);
  SO_ENABLE(SoPickAction, SoHapticPropertyElement);
}

SoHapticProperty::SoHapticProperty() {
  SO_NODE_CONSTRUCTOR(SoHapticProperty);
}

SoHapticProperty::~SoHapticProperty() = default;

void SoHapticProperty::doAction(SoAction* action) {
  SoHapticPropertyElement::set(action->getState(), this);
}
void SoHapticProperty::callback(SoCallbackAction* action) {
  doAction(action);
}
void SoHapticProperty::pick(SoPickAction* action) {
  doAction(action);
}

}  // namespace haptiv
