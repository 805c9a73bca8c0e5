#pragma once

#include <QWidget>

#include "app/plots/TickPlots.h"

namespace haptiv {

/// The plots of a running session, side by side: force and position.
class LivePlots : public QWidget {
  Q_OBJECT
 public:
  explicit LivePlots(QWidget* parent = nullptr);

  /// Shows one more tick; meant to be called with the newest one as often as the display is drawn.
  void append(const TickRecord& record);
  /// For the next session.
  void clear();

 private:
  SignalPlot* force_;
  SignalPlot* position_;
};

}  // namespace haptiv
