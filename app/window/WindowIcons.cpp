#include "app/window/WindowIcons.h"

#include <QPainterPath>

#include "app/view/StrokeIcon.h"

namespace haptiv {
namespace {

const QColor kAccent(226, 112, 38);

// A ball and the arrow that pulls it.
void drawHand(QPainter& painter) {
  painter.drawLine(22, 26, 38, 10);
  const QPointF head[] = {{27, 10}, {38, 10}, {38, 21}};
  painter.drawPolyline(head, 3);
  painter.setPen(Qt::NoPen);
  painter.setBrush(kAccent);
  painter.drawEllipse(QPointF(17, 31), 10, 10);
}

void drawPointer(QPainter& painter) {
  painter.setBrush(Qt::white);
  const QPointF arrow[] = {{14, 6}, {14, 36}, {21, 29}, {26, 41}, {31, 39}, {26, 27}, {35, 27}};
  painter.drawPolygon(arrow, 7);
}

// An eye that looks straight down on a plane.
void drawFromAbove(QPainter& painter) {
  painter.drawLine(24, 6, 24, 24);
  const QPointF head[] = {{18, 19}, {24, 26}, {30, 19}};
  painter.drawPolyline(head, 3);
  const QPointF plane[] = {{5, 41}, {14, 31}, {43, 31}, {34, 41}};
  painter.drawPolygon(plane, 4);
}

void drawShowAll(QPainter& painter) {
  for (const int turn : {0, 90, 180, 270}) {
    painter.save();
    painter.translate(24, 24);
    painter.rotate(turn);
    const QPointF corner[] = {{-17, -8}, {-17, -17}, {-8, -17}};
    painter.drawPolyline(corner, 3);
    painter.restore();
  }
  painter.drawRect(17, 17, 14, 14);
}

void drawArm(QPainter& painter) {
  const QPointF links[] = {{8, 38}, {14, 14}, {31, 9}, {40, 30}};
  painter.drawPolyline(links, 4);
  painter.setBrush(Qt::white);
  for (int i = 0; i < 3; ++i) painter.drawEllipse(links[i], 4, 4);
  painter.setPen(Qt::NoPen);
  painter.setBrush(kAccent);
  painter.drawEllipse(links[3], 5, 5);
}

// The button that every laboratory knows: a red mushroom on yellow.
void drawEmergencyStop(QPainter& painter) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(245, 200, 40));
  painter.drawEllipse(QPointF(24, 24), 20, 20);
  painter.setBrush(QColor(200, 20, 30));
  painter.drawEllipse(QPointF(24, 24), 13, 13);
}

}  // namespace

QIcon iconOf(WindowIcon icon) {
  switch (icon) {
    case WindowIcon::hand:
      return strokeIcon(drawHand);
    case WindowIcon::select:
      return strokeIcon(drawPointer);
    case WindowIcon::fromAbove:
      return strokeIcon(drawFromAbove);
    case WindowIcon::showAll:
      return strokeIcon(drawShowAll);
    case WindowIcon::arm:
      return strokeIcon(drawArm);
    case WindowIcon::emergencyStop:
      return strokeIcon(drawEmergencyStop);
  }
  return {};
}

}  // namespace haptiv
