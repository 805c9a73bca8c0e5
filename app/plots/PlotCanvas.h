#pragma once

#include <qwt_plot.h>

#include <QColor>
#include <QString>
#include <vector>

namespace haptiv {

/// How all plots look: white, a light grid, small grey labels, the time in seconds, no frame but a thin line. The space
/// beside the axes is fixed, so that nothing moves while a plot rolls.
QwtPlot* makePlot(QWidget* parent);

/// x, y and z as in the axes of a 3-D view: red, green, blue; others in the order of their index.
QColor curveColour(const QString& name, int index);

/// Rich text: the title, and the curves' names in their colours.
QString plotHeader(const QString& title, const std::vector<QString>& names);

}  // namespace haptiv
