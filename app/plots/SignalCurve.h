#pragma once

#include <qwt_plot_item.h>

#include <QColor>
#include <QPointF>
#include <QVector>

namespace haptiv {

/// A line through points, thin and smooth. In place of QwtPlotCurve, whose header in Qwt 6.1 is not C++20.
class SignalCurve : public QwtPlotItem {
 public:
  explicit SignalCurve(const QColor& colour) : colour_(colour) { setZ(20); }

  /// @param points  time [s] and value
  void setPoints(const QVector<QPointF>& points) { points_ = points; }
  void draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap, const QRectF& canvas) const override;

 private:
  QColor colour_;
  QVector<QPointF> points_;
};

}  // namespace haptiv
