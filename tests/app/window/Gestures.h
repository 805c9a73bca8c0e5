#pragma once

#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QTest>
#include <QWidget>
#include <functional>

namespace haptiv::testing {

/// Lets the program run until `condition` holds; false where it does not within `milliseconds`.
inline bool waitFor(const std::function<bool()>& condition, int milliseconds = 10000) {
  QElapsedTimer clock;
  clock.start();
  while (!condition()) {
    if (clock.elapsed() > milliseconds) return false;
    QTest::qWait(10);
  }
  return true;
}

/// The widget that gets the mouse at this place of `view`, and the place in it.
struct MousePlace {
  QWidget* widget;
  QPoint point;
};
inline MousePlace mousePlace(QWidget& view, const QPointF& place) {
  const QPoint point = place.toPoint();
  QWidget* child = view.childAt(point);
  if (child == nullptr) return {&view, point};
  return {child, child->mapFrom(&view, point)};
}

inline void press(QWidget& view, const QPointF& place) {
  const MousePlace at = mousePlace(view, place);
  QTest::mouseMove(at.widget, at.point);
  QTest::mousePress(at.widget, Qt::LeftButton, Qt::NoModifier, at.point);
}

inline void move(QWidget& view, const QPointF& place) {
  const MousePlace at = mousePlace(view, place);
  QMouseEvent event(QEvent::MouseMove, at.point, at.widget->mapToGlobal(at.point), Qt::NoButton, Qt::LeftButton,
                    Qt::NoModifier);
  QApplication::sendEvent(at.widget, &event);
  QTest::qWait(15);
}

/// Moves from one place to another in small steps, as a hand does.
inline void drag(QWidget& view, const QPointF& from, const QPointF& to, int steps = 20) {
  for (int i = 1; i <= steps; ++i) move(view, from + (to - from) * i / steps);
}

inline void release(QWidget& view, const QPointF& place) {
  const MousePlace at = mousePlace(view, place);
  QTest::mouseRelease(at.widget, Qt::LeftButton, Qt::NoModifier, at.point);
}

inline void click(QWidget& view, const QPointF& place) {
  press(view, place);
  release(view, place);
  QTest::qWait(50);
}

}  // namespace haptiv::testing
