#include "app/figures/CurveItem.h"

#include <qwt_scale_map.h>

#include <QLineF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/figures/LineStyle.h"

namespace haptiv {
namespace {

constexpr double kLeastStep = 0.7;  // [pixels] shorter ones are left out: dashes of a crowded line would run together
constexpr double kArrowHead = 14;   // [pixels]

/// Adds a point to a line, unless it is where the last one was.
void extend(QPolygonF& line, const QPointF& point) {
  if (line.isEmpty() || QLineF(line.last(), point).length() >= kLeastStep) line << point;
}

void drawArrowHead(QPainter& painter, const QPointF& from, const QPointF& to, const QColor& colour) {
  QLineF back(to, from);
  back.setLength(kArrowHead);
  QLineF left = back, right = back;
  left.setAngle(back.angle() + 24);
  right.setAngle(back.angle() - 24);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawPolygon(QPolygonF({to, left.p2(), right.p2()}));
  painter.setBrush(Qt::NoBrush);
}

}  // namespace

void CurveItem::draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap, const QRectF&) const {
  painter->setRenderHint(QPainter::Antialiasing);
  const std::size_t count = std::min(curve_.x.size(), curve_.y.size());
  QPolygonF line;
  const auto stroke = [&] {
    painter->setPen(linePen(curve_.style));
    if (curve_.line && line.size() > 1) painter->drawPolyline(line);
    line.clear();
  };
  for (std::size_t i = 0; i < count; ++i) {
    const QPointF point = QwtScaleMap::transform(xMap, yMap, {curve_.x[i], curve_.y[i]});
    if (std::isfinite(point.x()) && std::isfinite(point.y())) {
      extend(line, point);
      if (curve_.arrow && i + 1 == count && line.size() > 1)
        drawArrowHead(*painter, line[line.size() - 2], line.last(), linePen(curve_.style).color());
    } else {
      stroke();
    }
  }
  stroke();
  for (std::size_t i = 0; curve_.markers && i < count; ++i) {
    const QPointF point = QwtScaleMap::transform(xMap, yMap, {curve_.x[i], curve_.y[i]});
    if (std::isfinite(point.x()) && std::isfinite(point.y())) drawMarker(*painter, curve_.style, point);
  }
}

}  // namespace haptiv
