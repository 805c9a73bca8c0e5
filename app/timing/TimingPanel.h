#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QWidget>

#include "app/session/Session.h"
#include "app/timing/TimingChart.h"

namespace haptiv {

/// How punctual the servo of the running session is, live: the chart, and its figures in words. Thread: GUI.
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

 private:
  TimingChart* chart_;
  QLabel* wakeUps_;
  QLabel* ticks_;
  QLabel* share_;
  QElapsedTimer shown_;
};

}  // namespace haptiv
