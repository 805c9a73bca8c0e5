#pragma once

#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QWidget>

#include "app/session/Session.h"
#include "app/timing/TimingChart.h"

namespace haptiv {

/// How punctual the servo of the running session is, live: the chart, its figures in words, and the choice of the rate.
/// Thread: GUI.
class TimingPanel : public QWidget {
  Q_OBJECT

 public:
  explicit TimingPanel(QWidget* parent = nullptr);

  /// True a few times a second: often enough to be read, and no more work than that.
  bool isDue() const;
  /// @param rate  of the session [Hz]
  void show(const SessionTiming& timing, std::uint64_t missedTicks, double rate);
  /// No session runs.
  void clear();

  QSize minimumSizeHint() const override { return {360, 110}; }

 signals:
  /// For the next session [Hz]; while one runs there is nothing to choose.
  void rateChosen(double rate);

 private:
  TimingChart* chart_;
  QComboBox* rate_;
  QLabel* wakeUps_;
  QLabel* ticks_;
  QLabel* share_;
  QElapsedTimer shown_;
};

}  // namespace haptiv
