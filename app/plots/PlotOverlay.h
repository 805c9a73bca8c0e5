#pragma once

#include <qwt_plot.h>

#include <QLabel>
#include <optional>

namespace haptiv {

/// What lies over a plot's canvas and moves without a replot: the cursor, and a note while there is nothing to show.
/// The plot owns both. Thread: GUI.
class PlotOverlay {
 public:
  explicit PlotOverlay(QwtPlot& plot);

  void setNote(const QString& text) { note_->setText(text); }
  /// Over the whole canvas, as it is now.
  void showNote(bool shown);
  /// @param time  [s]; nothing: no cursor
  void placeCursor(std::optional<double> time);

 private:
  QwtPlot& plot_;
  QWidget* cursor_;
  QLabel* note_;
};

}  // namespace haptiv
