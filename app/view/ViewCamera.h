#pragma once

#include <Inventor/SbBox3f.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSwitch.h>

#include <QPointF>
#include <QSize>
#include <vector>

#include "device/types.h"
#include "scenegraph/NodeRef.h"

namespace haptiv {

/// A straight line into the picture, in W.
struct ViewRay {
  Vector3 origin;     ///< [m]
  Vector3 direction;  ///< unit length
};

/// Where one looks from: a place looked at, a heading about the vertical, an elevation and a distance. Two cameras show
/// it: a perspective one, and an orthographic one straight from above with x to the right and y up. Both see the same
/// place equally large. Pixels count from the upper left. Thread: GUI.
class ViewCamera {
 public:
  ViewCamera();

  /// The cameras; stands before what they show.
  SoSwitch* root() const { return root_.get(); }
  void setFromAbove(bool fromAbove);
  bool isFromAbove() const { return fromAbove_; }

  /// The look goes around the place looked at. Leaves the view from above.
  void orbit(const QPointF& pixels, const QSize& picture);
  /// What was under one pixel comes under the other.
  void pan(const QPointF& from, const QPointF& to, const QSize& picture);
  /// Nearer by this factor, with `p_W` staying where it is in the picture.
  void zoom(double factor, const Vector3& p_W);
  /// As near as all boxes are wholly seen.
  void fit(const std::vector<SbBox3f>& boxes, double aspectRatio);

  /// As this camera looks, as far as that goes: upright, and around the place on which it focuses. Leaves the view from
  /// above. Nothing happens where its numbers make no view.
  void lookLike(const SoCamera& camera);

  ViewRay ray(const QPointF& pixel, const QSize& picture) const;
  /// Where a ray through the pixel meets the plane through the place looked at, facing the camera.
  Vector3 onFocalPlane(const QPointF& pixel, const QSize& picture) const;
  QPointF toPixel(const Vector3& p_W, const QSize& picture) const;
  /// Size of a pixel at this place [m].
  double metresPerPixel(const Vector3& p_W, const QSize& picture) const;
  /// About z; 0 looks along y, with x to the right [rad].
  double heading() const { return fromAbove_ ? 0 : heading_; }
  /// Unit length, into the picture.
  Vector3 direction() const;

 private:
  SoCamera* active() const;
  SbRotation orientation() const;
  void update();

  bool fromAbove_ = false;
  Vector3 target_ = Vector3::Zero();
  double heading_;
  double elevation_;
  double distance_ = 1;
  NodeRef<SoSwitch> root_;
  SoPerspectiveCamera* perspective_;
  SoOrthographicCamera* orthographic_;
};

}  // namespace haptiv
