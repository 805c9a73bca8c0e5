#pragma once

#include <Inventor/Qt/SoQtRenderArea.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/sensors/SoNodeSensor.h>

#include <QGLWidget>

#include "app/view/SceneView.h"
#include "app/view/ViewCamera.h"
#include "app/view/ViewMouse.h"
#include "app/view/drawn/RubberLine.h"

namespace haptiv {

/// What the view is made of, and what the mouse does in it. Private to SceneView's sources.
struct SceneView::Parts {
  static constexpr int kSamples = 4;  ///< of a pixel

  explicit Parts(SceneView& owner);

  QSize size() const { return area->getGLWidget()->size(); }
  SbViewportRegion region() const { return area->getViewportRegion(); }
  bool handle(const QEvent& event);
  void updateRubberLine();
  void changeFromAbove(bool fromAbove);
  std::unique_ptr<SoRayPickAction> pick(const QPointF& pixel) const;
  void click(const QPointF& pixel);
  Vector3 placeUnder(const QPointF& pixel) const;
  ViewMouse::Talk talk();

  SceneView& view;
  NodeRef<SoSeparator> root{new SoSeparator};
  SoSeparator* scene = new SoSeparator;
  SoSeparator* decorations = new SoSeparator;
  HapticOverlay overlay;
  RubberLine rubberLine;
  ViewCamera camera;
  ViewMouse mouse;
  bool knownFromAbove = false;
  SoNodeSensor overlaySensor;
  std::unique_ptr<SoQtRenderArea> area;
};

}  // namespace haptiv
