#include "app/plots/SignalCurve.h"

#include <qwt_painter.h>
#include <qwt_scale_map.h>

#include <QPainter>

namespace haptiv {

void SignalCurve::draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap, const QRectF&) const {
  QPolygonF line;
  line.reserve(points_.size());
  for (const QPointF& point : points_) line << QwtScaleMap::transform(xMap, yMap, point);
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(QPen(colour_, 1.3, Qt::SolidLine, Qt::FlatCap));
  QwtPainter::drawPolyline(painter, line);  // in short pieces: Qt strokes long crowded lines slowly
}

}  // namespace haptiv
