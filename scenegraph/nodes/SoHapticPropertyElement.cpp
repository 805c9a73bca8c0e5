#include "scenegraph/nodes/SoHapticPropertyElement.h"

#include "scenegraph/nodes/SoHapticProperty.h"

namespace haptiv {

SO_ELEMENT_SOURCE(SoHapticPropertyElement);

void SoHapticPropertyElement::initClass() {
  SO_ELEMENT_INIT_CLASS(SoHapticPropertyElement, inherited);
}

SoHapticPropertyElement::~SoHapticPropertyElement() = default;

void SoHapticPropertyElement::init(SoState* state) {
  inherited::init(state);
  property_ = nullptr;
}

void SoHapticPropertyElement::set(SoState* state, SoHapticProperty* property) {
  auto* element = static_cast<SoHapticPropertyElement*>(getElement(state, classStackIndex, property));
  if (element) element->property_ = property;
}

const SoHapticProperty* SoHapticPropertyElement::get(SoState* state) {
  return static_cast<const SoHapticPropertyElement*>(getConstElement(state, classStackIndex))->property_;
}

}  // namespace haptiv
