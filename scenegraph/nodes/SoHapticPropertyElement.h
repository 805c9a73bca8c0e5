#pragma once

#include <Inventor/elements/SoReplacedElement.h>

namespace haptiv {

class SoHapticProperty;

/// Which haptic property node is in force at a place of the graph: the last one before it, as with SoMaterial.
/// A Separator restores the one before. None in force: what follows is not felt.
class SoHapticPropertyElement : public SoReplacedElement {
  typedef SoReplacedElement inherited;
  SO_ELEMENT_HEADER(SoHapticPropertyElement);

 public:
  static void initClass();
  void init(SoState* state) override;

  static void set(SoState* state, SoHapticProperty* property);
  /// Null where none is in force.
  static const SoHapticProperty* get(SoState* state);

 protected:
  ~SoHapticPropertyElement() override;

 private:
  const SoHapticProperty* property_ = nullptr;
};

}  // namespace haptiv
