#pragma once

#include <QLabel>
#include <QStatusBar>

#include "app/window/SessionControl.h"

namespace haptiv {

/// The status bar: what state the program is in, and, of a running session, rate, missed ticks, force and how the servo
/// runs. Thread: GUI.
class SessionStatus : public QStatusBar {
  Q_OBJECT
 public:
  explicit SessionStatus(QWidget* parent = nullptr);

  /// State and what the user can do next, such as "Editing" and "drag a wall to move it".
  void showState(const QString& state, const QString& hint);
  void showTick(const TickRecord& record, double rate);
  void showScheduling(const Scheduling& scheduling);
  void clearSession();

 private:
  QLabel* state_;
  QLabel* hint_;
  QLabel* rate_;
  QLabel* missed_;
  QLabel* force_;
  QLabel* scheduling_;
};

}  // namespace haptiv
