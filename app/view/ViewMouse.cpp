#include "app/view/ViewMouse.h"

#include <cmath>

namespace haptiv {
namespace {

constexpr double kClickPixels = 4;  // farther is a drag
constexpr double kNotch = 120;      // Qt's units of one notch of the wheel
constexpr double kZoomOfNotch = 1.15;

}  // namespace

void ViewMouse::setLeftIsHand(bool hand) {
  letGo();
  leftIsHand_ = hand;
  mayBeClick_ = false;
  cursor_ = Qt::ArrowCursor;
}

bool ViewMouse::handle(const QEvent& event, const QSize& picture) {
  switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      return press(static_cast<const QMouseEvent&>(event), picture);
    case QEvent::MouseMove:
      return move(static_cast<const QMouseEvent&>(event), picture);
    case QEvent::MouseButtonRelease:
      return release(static_cast<const QMouseEvent&>(event));
    case QEvent::Wheel:
      wheel(static_cast<const QWheelEvent&>(event));
      return true;
    default:
      return false;
  }
}

bool ViewMouse::press(const QMouseEvent& event, const QSize& picture) {
  if (event.button() == Qt::RightButton || event.button() == Qt::MiddleButton) {
    mayBeClick_ = false;
    looking_ = event.button();
    last_ = event.localPos();
    return true;
  }
  if (event.button() != Qt::LeftButton) return true;
  pressed_ = event.localPos();
  mayBeClick_ = !leftIsHand_;
  if (!leftIsHand_) return false;
  const Ball ball = talk_.ball();
  if (grip_.reaches(pressed_, picture, ball.position, ball.radius)) {
    grip_.take(pressed_, ball.position);
    updateCursor(pressed_, picture);
    talk_.handMoved(grip_.target());
  }
  return true;
}

bool ViewMouse::move(const QMouseEvent& event, const QSize& picture) {
  const QPointF at = event.localPos();
  if (std::hypot(at.x() - pressed_.x(), at.y() - pressed_.y()) >= kClickPixels) mayBeClick_ = false;
  if (looking_ != Qt::NoButton) {
    look(at, picture);
    return true;
  }
  if (grip_.isHeld()) talk_.handMoved(grip_.drag(at, picture, event.modifiers() & Qt::ShiftModifier));
  updateCursor(at, picture);
  return leftIsHand_;
}

bool ViewMouse::release(const QMouseEvent& event) {
  if (event.button() == looking_) {
    looking_ = Qt::NoButton;
    return true;
  }
  if (event.button() != Qt::LeftButton) return true;
  letGo();
  if (mayBeClick_) talk_.clicked(event.localPos());
  mayBeClick_ = false;
  return leftIsHand_;
}

void ViewMouse::letGo() {
  if (!grip_.isHeld()) return;
  grip_.letGo();
  if (cursor_ == Qt::ClosedHandCursor) cursor_ = Qt::OpenHandCursor;
  talk_.handMoved(std::nullopt);
}

void ViewMouse::look(const QPointF& to, const QSize& picture) {
  if (looking_ == Qt::RightButton) {
    camera_.orbit(to - last_, picture);
  } else {
    camera_.pan(last_, to, picture);
  }
  last_ = to;
}

void ViewMouse::wheel(const QWheelEvent& event) {
  camera_.zoom(std::pow(kZoomOfNotch, event.angleDelta().y() / kNotch), talk_.placeUnder(event.position()));
}

void ViewMouse::updateCursor(const QPointF& pixel, const QSize& picture) {
  cursor_ = Qt::ArrowCursor;
  if (!leftIsHand_) return;
  const Ball ball = talk_.ball();
  if (grip_.reaches(pixel, picture, ball.position, ball.radius)) cursor_ = Qt::OpenHandCursor;
  if (grip_.isHeld()) cursor_ = Qt::ClosedHandCursor;
}

}  // namespace haptiv
