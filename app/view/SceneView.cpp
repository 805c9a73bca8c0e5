#include "app/view/SceneView.h"

#include <Inventor/Qt/SoQtRenderArea.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/draggers/SoDragger.h>
#include <Inventor/sensors/SoNodeSensor.h>

#include <QGLFramebufferObject>
#include <QGLWidget>
#include <QTimer>
#include <QVBoxLayout>

#include "app/view/CoinValues.h"
#include "app/view/QtEnvironment.h"
#include "app/view/ViewCamera.h"
#include "app/view/ViewMouse.h"
#include "app/view/drawn/Background.h"
#include "app/view/drawn/GroundGrid.h"
#include "app/view/drawn/RubberLine.h"
#include "app/view/drawn/StudioLights.h"

namespace haptiv {
namespace {

constexpr int kSamples = 4;
constexpr double kPickPixels = 2;
constexpr double kRoom = 15;  // in radii, around a ball that is alone: for what is to be added
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

struct SceneView::Parts {
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

SceneView::SceneView(QWidget* parent) : QWidget(parent), parts_(std::make_unique<Parts>(*this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(parts_->area->getWidget());
  parts_->area->getGLWidget()->setFocusPolicy(Qt::ClickFocus);
  setMinimumSize(320, 240);
}

SceneView::~SceneView() = default;

void SceneView::setScene(SoNode* root, bool viewAllOfIt) {
  const NodeRef<> kept(root);
  parts_->scene->removeAllChildren();
  if (root) parts_->scene->addChild(root);
  if (viewAllOfIt) viewAll();
}

HapticOverlay& SceneView::overlay() {
  return parts_->overlay;
}
SoSeparator* SceneView::decorations() {
  return parts_->decorations;
}
void SceneView::setLeftButton(LeftButton meaning) {
  parts_->mouse.setLeftIsHand(meaning == LeftButton::hand);
}
void SceneView::viewFromAbove() {
  parts_->changeFromAbove(true);
}
void SceneView::viewFreely() {
  parts_->changeFromAbove(false);
}
bool SceneView::isFromAbove() const {
  return parts_->camera.isFromAbove();
}

double SceneView::heading() const {
  return parts_->camera.heading();
}

void SceneView::viewAll() {
  SoGetBoundingBoxAction bounds(parts_->region());
  bounds.apply(parts_->scene);
  const Vector3 ball = parts_->overlay.ballPosition();
  const double room = bounds.getBoundingBox().isEmpty() ? kRoom : 1;
  const Vector3 radius = Vector3::Constant(room * parts_->overlay.ballRadius());
  parts_->camera.fit({bounds.getBoundingBox(), SbBox3f(toCoin(ball - radius), toCoin(ball + radius))},
                     static_cast<double>(parts_->size().width()) / parts_->size().height());
}

void SceneView::viewAsMeant() {
  SoSearchAction search;
  search.setType(SoCamera::getClassTypeId());
  search.apply(parts_->scene);
  if (!search.getPath()) return viewAll();
  parts_->camera.lookLike(*static_cast<SoCamera*>(static_cast<SoFullPath*>(search.getPath())->getTail()));
  parts_->changeFromAbove(false);
}

void SceneView::redraw() {
  parts_->area->scheduleRedraw();
}

QImage SceneView::grabImage() {
  auto* widget = qobject_cast<QGLWidget*>(parts_->area->getGLWidget());
  widget->makeCurrent();
  QGLFramebufferObjectFormat format;
  format.setAttachment(QGLFramebufferObject::CombinedDepthStencil);
  format.setSamples(kSamples);
  QGLFramebufferObject buffer(parts_->size(), format);
  buffer.bind();
  parts_->area->getSceneManager()->render(parts_->area->getGLRenderAction());
  buffer.release();
  QImage image = buffer.toImage();
  image.reinterpretAsFormat(QImage::Format_RGB32);  // what blending left in the alpha channel means nothing
  return image;
}

QPointF SceneView::toWidget(const Vector3& p_W) const {
  return parts_->area->getGLWidget()->mapTo(this, QPoint()) + parts_->camera.toPixel(p_W, parts_->size());
}

// The first frames of a SoQt area can stay black: draws again when the window has settled.
void SceneView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  for (int milliseconds : {50, 250, 1000}) QTimer::singleShot(milliseconds, this, [this] { redraw(); });
}

void SceneView::hideEvent(QHideEvent* event) {
  parts_->mouse.letGo();
  QWidget::hideEvent(event);
}

}  // namespace haptiv
