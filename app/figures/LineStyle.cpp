#include "app/figures/LineStyle.h"

#include <QPainter>
#include <QPolygonF>
#include <array>
#include <vector>

namespace haptiv {
namespace {

constexpr double kWidth = 2;         // of lines [pixels]
constexpr double kMarkerRadius = 5;  // [pixels]

enum class Symbol { circle, square, diamond, triangle };

struct Style {
  QRgb colour;
  std::vector<qreal> dashes;  // in line widths, ink and gap by turns; empty: a whole line
  Symbol symbol;
};

/// Colours of Okabe and Ito, which the colour-blind can tell apart; the last ones are greys for what stands behind.
const std::vector<Style>& styles() {
  static const std::vector<Style> kStyles = {
      {0xff1b1e21, {}, Symbol::circle},         {0xff0072b2, {6, 2.5}, Symbol::square},
      {0xffd55e00, {}, Symbol::diamond},        {0xff009e73, {6, 2, 1.2, 2}, Symbol::triangle},
      {0xffcc79a7, {1.2, 1.6}, Symbol::circle}, {0xff868e96, {}, Symbol::square},
      {0xff868e96, {3, 3}, Symbol::diamond},
  };
  return kStyles;
}

const Style& styleOf(int style) {
  return styles()[static_cast<std::size_t>(style) % styles().size()];
}

QPolygonF outline(Symbol symbol) {
  constexpr double r = kMarkerRadius;
  switch (symbol) {
    case Symbol::square:
      return QPolygonF(QRectF(-0.85 * r, -0.85 * r, 1.7 * r, 1.7 * r));
    case Symbol::diamond:
      return QPolygonF({{0, -1.2 * r}, {1.2 * r, 0}, {0, 1.2 * r}, {-1.2 * r, 0}});
    case Symbol::triangle:
      return QPolygonF({{0, -1.1 * r}, {1.1 * r, 0.9 * r}, {-1.1 * r, 0.9 * r}});
    case Symbol::circle:
      break;
  }
  return {};
}

}  // namespace

QPen linePen(int style) {
  const Style& chosen = styleOf(style);
  QPen pen(QColor(chosen.colour), kWidth, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
  if (!chosen.dashes.empty()) pen.setDashPattern(QVector<qreal>(chosen.dashes.begin(), chosen.dashes.end()));
  return pen;
}

void drawMarker(QPainter& painter, int style, const QPointF& at) {
  const Style& chosen = styleOf(style);
  painter.setPen(QPen(Qt::white, 1));
  painter.setBrush(QColor(chosen.colour));
  if (chosen.symbol == Symbol::circle) {
    painter.drawEllipse(at, kMarkerRadius, kMarkerRadius);
  } else {
    painter.drawPolygon(outline(chosen.symbol).translated(at));
  }
  painter.setBrush(Qt::NoBrush);
}

}  // namespace haptiv
