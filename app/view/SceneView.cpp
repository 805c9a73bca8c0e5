#include "app/view/SceneView.h"

#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/actions/SoSearchAction.h>

#include <QGLFramebufferObject>
#include <QTimer>
#include <QVBoxLayout>

#include "app/view/SceneViewParts.h"
#include "scenegraph/CoinValues.h"

namespace haptiv {
namespace {

constexpr double kRoom = 15;  // in radii, around a ball that is alone: for what is to be added

}  // namespace

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
  format.setSamples(Parts::kSamples);
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

#include "moc_SceneView.cpp"
