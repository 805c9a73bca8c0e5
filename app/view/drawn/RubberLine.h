#pragma once

#include <Inventor/nodes/SoAnnotation.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoSphere.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTranslation.h>

#include "device/types.h"
#include "scenegraph/NodeRef.h"

namespace haptiv {

/// A thin line from the ball to where the hand wants it, with a dot there; seen through walls, for the hand pulls into
/// them. Thread: GUI.
class RubberLine {
 public:
  RubberLine();

  SoSwitch* root() const { return root_.get(); }
  void show(const Vector3& ball, double ballRadius, const Vector3& hand);
  void hide();

 private:
  NodeRef<SoSwitch> root_;
  SoCoordinate3* ends_;
  SoTranslation* handPlace_;
  SoSphere* dot_;
};

}  // namespace haptiv
