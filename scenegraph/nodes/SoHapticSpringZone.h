#pragma once

#include <Inventor/fields/SoSFBool.h>
#include <Inventor/fields/SoSFFloat.h>
#include <Inventor/fields/SoSFString.h>
#include <Inventor/fields/SoSFVec3f.h>

#include "scenegraph/nodes/SoHapticProperty.h"

namespace haptiv {

/// The shapes after it are regions in which a spring draws the tool to the anchor:
/// f = stiffness * (length - restLength) towards the anchor.
/// In files: HapticSpringZone.
class SoHapticSpringZone : public SoHapticProperty {
  typedef SoHapticProperty inherited;
  SO_NODE_HEADER(SoHapticSpringZone);

 public:
  static void initClass();
  SoHapticSpringZone();

  SoSFFloat stiffness;   ///< [N/m], not negative
  SoSFVec3f anchor;      ///< [m], in the local coordinates of the shape: its transforms move it
  SoSFFloat restLength;  ///< [m], not negative
  SoSFBool enabled;      ///< FALSE: the shapes are not felt
  SoSFString label;      ///< the name a person gave it; free text

  bool isFelt() const override;

 protected:
  ~SoHapticSpringZone() override;
};

}  // namespace haptiv
