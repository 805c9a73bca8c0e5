#pragma once

#include <QWidget>
#include <memory>

#include "app/plots/SignalPlot.h"
#include "app/replay/ReplayPlayer.h"

namespace haptiv {

/// The time line below the view: controls, and plots of force, position and energy that share their cursor and their
/// zoom.
///
/// Keys: space plays and pauses, left and right go one tick (with shift: 10 ms), Home and End to the ends.
class ReplayBar : public QWidget {
  Q_OBJECT
 public:
  explicit ReplayBar(QWidget* parent = nullptr);
  ~ReplayBar() override;

  /// Shows this player's log (not owned); null: empty and disabled.
  void setPlayer(ReplayPlayer* player);

 private:
  void layOut();
  void addKeys();
  void connectPlayer();
  void showTime();
  void showCurves();
  void shareRange(double from, double to);
  void keepCursorInSight(double time);

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
