#pragma once

#include "scenegraph/nodes/SoHapticSpringZone.h"

namespace haptiv {

/// The shapes after it are regions in which a rubber band draws the tool to the anchor, and only while it is longer
/// than its rest length: f = stiffness * max(0, length - restLength) towards the anchor. Fields as of the spring zone.
/// In files: HapticRubberBand.
class SoHapticRubberBand : public SoHapticSpringZone {
  typedef SoHapticSpringZone inherited;
  SO_NODE_HEADER(SoHapticRubberBand);

 public:
  static void initClass();
  SoHapticRubberBand();

 protected:
  ~SoHapticRubberBand() override;
};

}  // namespace haptiv
