#pragma once

#include <qwt_plot_item.h>

#include "app/figures/Figure.h"

namespace haptiv {

/// Draws a FigureCurve. (Qwt's own curve item does not compile as C++20.)
class CurveItem : public QwtPlotItem {
 public:
  explicit CurveItem(FigureCurve curve) : curve_(std::move(curve)) {}

  void draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap, const QRectF& canvas) const override;

 private:
  FigureCurve curve_;
};

}  // namespace haptiv
