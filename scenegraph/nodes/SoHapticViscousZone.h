#pragma once

#include <Inventor/fields/SoSFBool.h>
#include <Inventor/fields/SoSFFloat.h>
#include <Inventor/fields/SoSFString.h>

#include "scenegraph/nodes/SoHapticProperty.h"

namespace haptiv {

/// The shapes after it are regions of a viscous medium: f = -damping * velocity inside.
/// In files: HapticViscousZone.
class SoHapticViscousZone : public SoHapticProperty {
  typedef SoHapticProperty inherited;
  SO_NODE_HEADER(SoHapticViscousZone);

 public:
  static void initClass();
  SoHapticViscousZone();

  SoSFFloat damping;  ///< [N s/m], not negative
  SoSFBool enabled;   ///< FALSE: the shapes are not felt
  SoSFString label;   ///< the name a person gave it; free text

  bool isFelt() const override;

 protected:
  ~SoHapticViscousZone() override;
};

}  // namespace haptiv
