#pragma once

#include "app/view/ViewCamera.h"

namespace haptiv {

/// The mouse as a hand: turns its way over the picture into where the hand wants the ball.
///
/// The hand moves in the horizontal plane in which it took hold; with Shift, straight up and down. Seen flatter than
/// kFlat, it moves in the plane that faces the camera. What was gripped stays under the mouse: no jump.
class HandGrip {
 public:
  static constexpr double kFlat = 20;     ///< [degrees] of elevation
  static constexpr double kReach = 12;    ///< takes hold within so many pixels of the ball's outline
  static constexpr double kFarthest = 3;  ///< the hand wants nothing farther than this from where it took hold [m]

  explicit HandGrip(const ViewCamera& camera) : camera_(camera) {}

  /// Whether a press here would take hold of the ball.
  bool reaches(const QPointF& pixel, const QSize& picture, const Vector3& p_WT, double radius) const;
  void take(const QPointF& pixel, const Vector3& p_WT);
  void letGo() { held_ = false; }
  bool isHeld() const { return held_; }
  /// Where the hand wants the ball, p_WH [m], with the mouse there now.
  Vector3 drag(const QPointF& pixel, const QSize& picture, bool upAndDown);
  Vector3 target() const { return target_; }

 private:
  void restart(const QPointF& pixel);
  Vector3 moved(const QPointF& pixel, const QSize& picture) const;

  const ViewCamera& camera_;
  bool held_ = false;
  bool upAndDown_ = false;
  Vector3 taken_ = Vector3::Zero();  // where the ball was when the hand took hold
  Vector3 target_ = Vector3::Zero();
  Vector3 start_ = Vector3::Zero();  // target at the press, or when Shift changed ...
  QPointF startPixel_;               // ... and the mouse then
};

}  // namespace haptiv
