#pragma once

#include <Inventor/fields/SoSFBool.h>
#include <Inventor/fields/SoSFFloat.h>
#include <Inventor/fields/SoSFString.h>

#include "scenegraph/nodes/SoHapticProperty.h"

namespace haptiv {

/// The shapes after it are solid: they push the tool out along their outward normal,
/// f = stiffness * depth + damping * speed inwards, and never pull.      [paper, eqs. (26), (27)]
/// In files: HapticSurface.
class SoHapticSurface : public SoHapticProperty {
  typedef SoHapticProperty inherited;
  SO_NODE_HEADER(SoHapticSurface);

 public:
  static void initClass();
  SoHapticSurface();

  SoSFFloat stiffness;        ///< [N/m], not negative
  SoSFFloat damping;          ///< [N s/m], not negative; only while moving in
  SoSFFloat hysteresis;       ///< [m], not negative
  SoSFFloat staticFriction;   ///< coefficient [1], not negative
  SoSFFloat dynamicFriction;  ///< coefficient [1], not negative
  SoSFBool enabled;           ///< FALSE: the shapes are not felt
  SoSFString label;           ///< the name a person gave it; free text

  bool isFelt() const override;

 protected:
  ~SoHapticSurface() override;
};

}  // namespace haptiv
