#pragma once

#include <QMouseEvent>
#include <QWheelEvent>
#include <functional>
#include <optional>

#include "app/view/HandGrip.h"
#include "app/view/ViewCamera.h"

namespace haptiv {

/// What the mouse means in the 3-D view: looks around by itself, and tells of clicks and of the hand. Thread: GUI.
class ViewMouse {
 public:
  struct Ball {
    Vector3 position;  ///< p_WT [m]
    double radius;     ///< [m]
  };
  /// What the mouse asks and tells.
  struct Talk {
    std::function<Ball()> ball;
    std::function<Vector3(const QPointF&)> placeUnder;  ///< the place in the scene that a pixel shows
    std::function<void(const QPointF&)> clicked;
    std::function<void(const std::optional<Vector3>&)> handMoved;
  };

  ViewMouse(ViewCamera& camera, Talk talk) : camera_(camera), grip_(camera), talk_(std::move(talk)) {}

  /// True: the left button is the hand. False: it selects.
  void setLeftIsHand(bool hand);
  /// True: the event is spent; false: it is for the handles in the scene too.
  bool handle(const QEvent& event, const QSize& picture);
  /// The hand lets go, if it holds the ball.
  void letGo();
  const HandGrip& grip() const { return grip_; }
  Qt::CursorShape cursor() const { return cursor_; }

 private:
  bool press(const QMouseEvent& event, const QSize& picture);
  bool move(const QMouseEvent& event, const QSize& picture);
  bool release(const QMouseEvent& event);
  void look(const QPointF& to, const QSize& picture);
  void wheel(const QWheelEvent& event);
  void updateCursor(const QPointF& pixel, const QSize& picture);

  ViewCamera& camera_;
  HandGrip grip_;
  Talk talk_;
  bool leftIsHand_ = false;
  bool mayBeClick_ = false;
  Qt::MouseButton looking_ = Qt::NoButton;  // which button looks around now
  QPointF last_;
  QPointF pressed_;
  Qt::CursorShape cursor_ = Qt::ArrowCursor;
};

}  // namespace haptiv
