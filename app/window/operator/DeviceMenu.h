#pragma once

#include <QMenu>
#include <string>

class QActionGroup;

namespace haptiv {

/// The menu by which the user chooses the arm of the next session: the simulated one, or an interface board that is
/// plugged in. The boards are looked for whenever the menu is opened. Thread: GUI.
class DeviceMenu : public QMenu {
  Q_OBJECT
 public:
  explicit DeviceMenu(QWidget* parent = nullptr);

  /// What is chosen, as after `--device`.
  const QString& device() const { return chosen_; }

 signals:
  /// As after `--device`: "sim", or "usb:SERIAL".
  void chosen(const QString& device);

 private:
  void refresh();
  void offer(const QString& device, const QString& text, const QString& trouble);

  QActionGroup* group_;
  QString chosen_ = "sim";
};

}  // namespace haptiv
