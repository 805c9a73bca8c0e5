#pragma once

#include <QWidget>

#include "app/plots/TickPlots.h"

namespace haptiv {

/// The plots of a running session, side by side: force, position and the energy of passivity.
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
  SignalPlot* energy_;
};

}  // namespace haptiv
