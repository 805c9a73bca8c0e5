#pragma once

#include <Inventor/SbColor.h>
#include <Inventor/nodes/SoCone.h>
#include <Inventor/nodes/SoCylinder.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTransform.h>
#include <Inventor/nodes/SoTranslation.h>

#include "device/types.h"
#include "scenegraph/NodeRef.h"

namespace haptiv {

/// An arrow that starts at the ball's surface and points along a force. Drawn over all else: the arm and walls do not
/// hide what the hand feels. Thread: GUI.
class ForceArrow {
 public:
  static constexpr double kMetresPerNewton = 0.005;
  static constexpr double kLongest = 0.15;       ///< [m]; stronger forces are drawn no longer
  static constexpr double kWeakestShown = 0.05;  ///< [N]

  /// @param thickness  relative to an arrow of full weight
  ForceArrow(const SbColor& color, double thickness);

  SoSeparator* root() const { return root_.get(); }
  void setBallRadius(double radius) { ballRadius_ = radius; }
  /// @param p_WT  the ball's centre [m]   @param force  in W [N]
  void show(const Vector3& p_WT, const Vector3& force);

 private:
  void setLength(double length);

  double thickness_;
  double ballRadius_ = 0.01;
  NodeRef<SoSeparator> root_;
  SoSwitch* shown_;
  SoTransform* place_;
  SoTranslation* toShaft_;
  SoCylinder* shaft_;
  SoTranslation* toHead_;
  SoCone* head_;
};

}  // namespace haptiv
