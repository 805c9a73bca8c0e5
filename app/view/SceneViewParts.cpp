#include "app/view/SceneViewParts.h"

#include <Inventor/SoPickedPoint.h>
#include <Inventor/draggers/SoDragger.h>

#include "app/view/QtEnvironment.h"
#include "app/view/drawn/Background.h"
#include "app/view/drawn/GroundGrid.h"
#include "app/view/drawn/StudioLights.h"
#include "scenegraph/CoinValues.h"

namespace haptiv {
namespace {

constexpr double kPickPixels = 2;
constexpr double kArmTransparency = 0.25;
constexpr double kArmTransparencyFromAbove = 0.85;  // there it lies over all else

/// The part of a picked path from `root` to the shape; null where the path does not go through it, or where what was
/// picked is a handle.
SoPath* pathWithin(const SoPath& picked, const SoNode* root) {
  const auto& path = static_cast<const SoFullPath&>(picked);
  for (int i = 0; i < path.getLength(); ++i) {
    if (path.getNode(i)->isOfType(SoDragger::getClassTypeId())) return nullptr;
  }
  for (int i = 0; i < path.getLength(); ++i) {
    if (path.getNode(i) == root) return picked.copy(i);
  }
  return nullptr;
}

}  // namespace

SceneView::Parts::Parts(SceneView& owner) : view(owner), mouse(camera, talk()) {
  root->renderCaching = SoSeparator::OFF;
  for (SoNode* node :
       std::initializer_list<SoNode*>{makeBackground(), camera.root(), makeStudioLights(), scene, makeGroundGrid(),
                                      decorations, overlay.root(), rubberLine.root()}) {
    root->addChild(node);
  }
  overlay.setArmTransparency(kArmTransparency);
  overlaySensor.setFunction([](void* parts, SoSensor*) { static_cast<Parts*>(parts)->updateRubberLine(); });
  overlaySensor.setData(this);
  overlaySensor.attach(overlay.root());

  area = std::make_unique<SoQtRenderArea>(&view, "view", TRUE);
  area->setBorder(FALSE);
  area->setStealFocus(FALSE);
  area->setTransparencyType(SoGLRenderAction::SORTED_OBJECT_BLEND);
  if (!drawsInSoftware()) area->setSampleBuffers(kSamples);
  area->setSceneGraph(root.get());
  area->setEventCallback(
      [](void* parts, QEvent* event) -> SbBool { return static_cast<Parts*>(parts)->handle(*event); }, this);
}

ViewMouse::Talk SceneView::Parts::talk() {
  ViewMouse::Talk talk;
  talk.ball = [this] { return ViewMouse::Ball{overlay.ballPosition(), overlay.ballRadius()}; };
  talk.placeUnder = [this](const QPointF& pixel) { return placeUnder(pixel); };
  talk.clicked = [this](const QPointF& pixel) { click(pixel); };
  talk.handMoved = [this](const std::optional<Vector3>& p_WH) {
    updateRubberLine();
    emit view.handMoved(p_WH);
  };
  return talk;
}

bool SceneView::Parts::handle(const QEvent& event) {
  const bool spent = mouse.handle(event, size());
  QWidget* widget = area->getGLWidget();
  if (widget->cursor().shape() != mouse.cursor()) widget->setCursor(mouse.cursor());
  changeFromAbove(camera.isFromAbove());
  return spent;
}

void SceneView::Parts::updateRubberLine() {
  if (mouse.grip().isHeld()) {
    rubberLine.show(overlay.ballPosition(), overlay.ballRadius(), mouse.grip().target());
  } else {
    rubberLine.hide();
  }
}

void SceneView::Parts::changeFromAbove(bool fromAbove) {
  if (camera.isFromAbove() != fromAbove) camera.setFromAbove(fromAbove);
  overlay.setArmTransparency(fromAbove ? kArmTransparencyFromAbove : kArmTransparency);
  if (knownFromAbove == fromAbove) return;
  knownFromAbove = fromAbove;
  emit view.fromAboveChanged(fromAbove);
}

std::unique_ptr<SoRayPickAction> SceneView::Parts::pick(const QPointF& pixel) const {
  auto action = std::make_unique<SoRayPickAction>(region());
  const QSize picture = size();
  action->setPoint(SbVec2s(static_cast<short>(pixel.x()), static_cast<short>(picture.height() - 1 - pixel.y())));
  action->setRadius(kPickPixels);
  action->apply(root.get());
  return action;
}

void SceneView::Parts::click(const QPointF& pixel) {
  const auto action = pick(pixel);
  const SoPickedPoint* point = action->getPickedPoint();
  if (!point || scene->getNumChildren() == 0) {
    emit view.shapeClicked(nullptr);
    return;
  }
  SoPath* path = pathWithin(*point->getPath(), scene->getChild(0));
  if (!path) return;
  path->ref();
  emit view.shapeClicked(path);
  path->unref();
}

Vector3 SceneView::Parts::placeUnder(const QPointF& pixel) const {
  const auto action = pick(pixel);
  const SoPickedPoint* point = action->getPickedPoint();
  return point ? toEigen(point->getPoint()) : camera.onFocalPlane(pixel, size());
}

}  // namespace haptiv
