#pragma once

#include <qwt_plot.h>

#include <QEvent>

namespace haptiv {

/// What the mouse asks of a standing plot: press or drag picks a time, the wheel zooms about the pointer, a double
/// click wants all.
struct PlotGesture {
  enum class Kind { none, pick, zoom, showAll };

  Kind kind = Kind::none;
  double time = 0;    ///< under the pointer [s]; pick and zoom
  double factor = 1;  ///< of the shown span; zoom
};

/// @param event  that came to the plot's canvas
PlotGesture gestureOf(const QEvent& event, const QwtPlot& plot);

}  // namespace haptiv
