#pragma once

#include <QWidget>
#include <memory>

#include "app/plots/SignalPlot.h"
#include "app/replay/ReplayPlayer.h"

namespace haptiv {

/// The time line below the view: play and pause, speed, a slider, the time, and plots of force and position that
/// share its cursor.
class ReplayBar : public QWidget {
  Q_OBJECT
 public:
  explicit ReplayBar(QWidget* parent = nullptr);
  ~ReplayBar() override;

  /// Shows this player's log (not owned); null: empty and disabled.
  void setPlayer(ReplayPlayer* player);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace haptiv
