#pragma once

#include <Inventor/nodes/SoSeparator.h>

#include <memory>

#include "app/view/ellipsoids/DexterityFigure.h"
#include "device/described/DeviceDescription.h"
#include "haptics/scene/HapticScene.h"
#include "haptics/tick/TickRecord.h"
#include "scenegraph/NodeRef.h"

namespace haptiv {

/// What moves in the picture of a session: the arm, the ball, the forces on it, and, if wanted, the manipulability
/// ellipsoids. A graph of its own beside the scene's, never saved. Thread: GUI.
class HapticOverlay {
 public:
  HapticOverlay();
  ~HapticOverlay();

  /// To be put beside the scene under one root.
  SoSeparator* root() const { return root_.get(); }
  /// Arm and ball of this scene, at rest at the tool's home; no force.
  void setUp(const HapticScene& scene, const DeviceDescription& description);
  /// Arm, ball and arrow as of this tick. Touches a field only where its value has changed.
  void show(const TickRecord& record);
  /// Where the arm is in the way of the view.
  void setArmVisible(bool visible);
  /// Hidden at first.
  void setEllipsoidVisible(Manipulability which, bool visible);
  /// 0: solid, 1: not seen.
  void setArmTransparency(double transparency);
  /// Where the ball is drawn, p_WT [m], and its radius [m].
  Vector3 ballPosition() const;
  double ballRadius() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
  NodeRef<SoSeparator> root_;
};

}  // namespace haptiv
