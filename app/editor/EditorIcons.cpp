#include "app/editor/EditorIcons.h"

#include <QPainterPath>

#include "app/view/StrokeIcon.h"

namespace haptiv {
namespace {

const QColor kBlue(52, 128, 214);
const QColor kOrange(226, 140, 38);
const QColor kGreen(60, 150, 84);

void drawWall(QPainter& painter) {
  painter.setBrush(QColor(176, 184, 196));
  painter.drawRect(5, 15, 38, 18);
  painter.drawLine(5, 24, 43, 24);
  for (const int x : {18, 31}) painter.drawLine(x, 15, x, 24);
  for (const int x : {12, 24, 37}) painter.drawLine(x, 24, x, 33);
}

void drawZone(QPainter& painter, QColor colour) {
  painter.setPen(QPen(colour, 3, Qt::DashLine));
  colour.setAlpha(50);
  painter.setBrush(colour);
  painter.drawRoundedRect(6, 6, 36, 36, 6, 6);
}

void drawWaves(QPainter& painter) {
  painter.setPen(QPen(kBlue, 3, Qt::SolidLine, Qt::RoundCap));
  painter.setBrush(Qt::NoBrush);
  for (const int y : {19, 29}) {
    QPainterPath wave(QPointF(13, y));
    wave.cubicTo(19, y - 8, 19, y - 8, 24, y);
    wave.cubicTo(29, y + 8, 29, y + 8, 35, y);
    painter.drawPath(wave);
  }
}

void drawSpring(QPainter& painter) {
  painter.setPen(QPen(kOrange, 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  const QPointF points[] = {{11, 24}, {16, 24}, {19, 16}, {23, 32}, {27, 16}, {31, 32}, {33, 24}, {37, 24}};
  painter.drawPolyline(points, 8);
}

// A band around two pegs.
void drawBand(QPainter& painter) {
  painter.setPen(QPen(kGreen, 3));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(11, 17, 26, 14, 7, 7);
  painter.setBrush(kGreen);
  for (const int x : {18, 30}) painter.drawEllipse(QPointF(x, 24), 3, 3);
}

// A cube with its faces filled.
void drawSolid(QPainter& painter) {
  const QPointF top[] = {{24, 5}, {41, 14}, {24, 23}, {7, 14}};
  const QPointF left[] = {{7, 14}, {24, 23}, {24, 43}, {7, 34}};
  const QPointF right[] = {{41, 14}, {24, 23}, {24, 43}, {41, 34}};
  painter.setBrush(QColor(216, 221, 228));
  painter.drawPolygon(top, 4);
  painter.setBrush(QColor(176, 184, 196));
  painter.drawPolygon(left, 4);
  painter.setBrush(QColor(140, 150, 164));
  painter.drawPolygon(right, 4);
}

void drawTurn(QPainter& painter, bool toTheLeft) {
  if (!toTheLeft) {
    painter.translate(kIconSide, 0);
    painter.scale(-1, 1);
  }
  painter.setBrush(Qt::NoBrush);
  QPainterPath arrow(QPointF(10, 19));
  arrow.lineTo(29, 19);
  arrow.cubicTo(43, 19, 43, 37, 29, 37);
  arrow.lineTo(20, 37);
  painter.drawPath(arrow);
  const QPointF head[] = {{19, 10}, {10, 19}, {19, 28}};
  painter.drawPolyline(head, 3);
}

void drawBin(QPainter& painter) {
  painter.setBrush(Qt::NoBrush);
  painter.drawLine(9, 13, 39, 13);
  painter.drawLine(20, 8, 28, 8);
  const QPointF can[] = {{13, 13}, {15, 41}, {33, 41}, {35, 13}};
  painter.drawPolyline(can, 4);
  for (const int x : {20, 28}) painter.drawLine(x, 20, x, 35);
}

void drawTwo(QPainter& painter) {
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(8, 8, 22, 22);
  painter.setBrush(Qt::white);
  painter.drawRect(18, 18, 22, 22);
}

void drawGrid(QPainter& painter) {
  for (const int at : {10, 24, 38}) {
    painter.drawLine(at, 6, at, 42);
    painter.drawLine(6, at, 42, at);
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(kBlue);
  painter.drawEllipse(QPointF(24, 24), 6, 6);
}

}  // namespace

QIcon editorIcon(EditorIcon icon) {
  switch (icon) {
    case EditorIcon::wall:
      return strokeIcon(drawWall);
    case EditorIcon::dampingZone:
      return strokeIcon([](QPainter& painter) {
        drawZone(painter, kBlue);
        drawWaves(painter);
      });
    case EditorIcon::springZone:
      return strokeIcon([](QPainter& painter) {
        drawZone(painter, kOrange);
        drawSpring(painter);
      });
    case EditorIcon::rubberBand:
      return strokeIcon([](QPainter& painter) {
        drawZone(painter, kGreen);
        drawBand(painter);
      });
    case EditorIcon::makeSolid:
      return strokeIcon(drawSolid);
    case EditorIcon::duplicate:
      return strokeIcon(drawTwo);
    case EditorIcon::remove:
      return strokeIcon(drawBin);
    case EditorIcon::undo:
      return strokeIcon([](QPainter& painter) { drawTurn(painter, true); });
    case EditorIcon::redo:
      return strokeIcon([](QPainter& painter) { drawTurn(painter, false); });
    case EditorIcon::grid:
      return strokeIcon(drawGrid);
  }
  return {};
}

}  // namespace haptiv
