#include "app/guide/SignedBar.h"

#include <QPainter>
#include <algorithm>

namespace haptiv {

SignedBar::SignedBar(QWidget* parent) : QWidget(parent) {
  setFixedHeight(12);
  setMinimumWidth(80);
}

void SignedBar::setShare(double share) {
  const double shown = std::clamp(share, -1.0, 1.0);
  if (shown == share_) return;
  share_ = shown;
  update();
}

void SignedBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.fillRect(frame, palette().base());
  const double middle = frame.center().x(), end = middle + share_ * frame.width() / 2;
  painter.fillRect(QRectF(QPointF(std::min(middle, end), frame.top()), QPointF(std::max(middle, end), frame.bottom())),
                   palette().highlight());
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(frame);
  painter.drawLine(QPointF(middle, frame.top()), QPointF(middle, frame.bottom()));
}

}  // namespace haptiv
