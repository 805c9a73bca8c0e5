#pragma once

#include <QObject>
#include <QTimer>
#include <cstdint>

namespace haptiv {

/// The operator's buttons of the simulated device, at the keyboard of a window: the space bar is the dead-man's button,
/// Esc an emergency stop, which stays pressed until the reset. Held keys count for as long as the window has the
/// keyboard: whoever turns to another window lets go.
///
/// Outside of sessions these keys are what they always are. Thread: GUI.
class OperatorKeys : public QObject {
  Q_OBJECT
 public:
  explicit OperatorKeys(QWidget& window);

  /// True: a session runs, nothing is pressed yet.
  void setActive(bool active);

 public slots:
  /// Presses the emergency stop.
  void stopAtOnce();
  /// Pulls the emergency stop out again and presses the reset for a moment.
  void reset();

 signals:
  /// What is pressed: OperatorInput bits.
  void pressed(std::uint16_t inputs);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool isForTheArm(const QEvent& event) const;
  void set(std::uint16_t input, bool down);

  QWidget& window_;
  QTimer resetPress_;
  std::uint16_t inputs_ = 0;
  bool active_ = false;
};

}  // namespace haptiv
