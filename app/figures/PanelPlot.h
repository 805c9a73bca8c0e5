#pragma once

#include <qwt_plot.h>

#include <QFont>
#include <memory>

#include "app/figures/Figure.h"

namespace haptiv {

/// The letters of all figures; sizes in pixels, so that a picture is the same on every machine.
QFont figureFont(int pixels, bool bold = false);

/// A panel as a Qwt plot. Needs a QApplication.
std::unique_ptr<QwtPlot> makePanelPlot(const FigurePanel& panel);

/// Widens one axis so that a unit is as long in x as in y when the plot is drawn into `area`.
void equaliseScales(QwtPlot& plot, const QRectF& area);

}  // namespace haptiv
