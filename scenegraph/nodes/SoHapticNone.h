#pragma once

#include "scenegraph/nodes/SoHapticProperty.h"

namespace haptiv {

/// The shapes after it are not felt: scenery. It has no fields.
/// In files: HapticNone.
class SoHapticNone : public SoHapticProperty {
  typedef SoHapticProperty inherited;
  SO_NODE_HEADER(SoHapticNone);

 public:
  static void initClass();
  SoHapticNone();

  bool isFelt() const override;

 protected:
  ~SoHapticNone() override;
};

}  // namespace haptiv
