#pragma once

#include <QLabel>
#include <QStatusBar>

#include "app/window/session/SessionControl.h"

namespace haptiv {

/// The status bar: what state the program is in, and, of a running session, its state, rate, missed ticks, force and
/// how the servo runs. Thread: GUI.
class SessionStatus : public QStatusBar {
  Q_OBJECT
 public:
  explicit SessionStatus(QWidget* parent = nullptr);

  /// State and what the user can do next, such as "Editing" and "drag a wall to move it".
  void showState(const QString& state, const QString& hint);
  void showTick(const TickRecord& record, double rate);
  /// What is wrong with the running session's log; stands where the hints stand until the session is over.
  void showTrouble(const QString& trouble);
  /// By what the hand is moved, for the hints; from the start it is the mouse.
  enum class HandBy { mouse, spaceMouse, device };
  void setHandBy(HandBy by) { handBy_ = by; }
  void showScheduling(const Scheduling& scheduling);
  void clearSession();

 private:
  void show(const QString& state, const QString& hint, const QString& colour);
  void showSessionState(const TickRecord& record);

  QLabel* state_;
  QLabel* hint_;
  QLabel* rate_;
  QLabel* missed_;
  QLabel* force_;
  QLabel* scheduling_;
  QString trouble_;
  HandBy handBy_ = HandBy::mouse;
};

}  // namespace haptiv
