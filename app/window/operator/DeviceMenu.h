#pragma once

#include <QMenu>
#include <vector>

#include "device/usb/PluggedDevices.h"

class QActionGroup;

namespace haptiv {

/// The menu by which the user chooses the arm of the next session: the simulated one, an interface board or a Falcon
/// that is plugged in. It looks for them whenever it is opened, and tells of SpaceMice too, which are chosen elsewhere.
/// Thread: GUI.
class DeviceMenu : public QMenu {
  Q_OBJECT
 public:
  explicit DeviceMenu(QWidget* parent = nullptr);

  /// What is chosen, as after `--device`.
  const QString& device() const { return chosen_; }
  /// The Falcon's firmware, whose absence is told; empty: where it is looked for.
  void setFirmware(const QString& path) { firmware_ = path; }

 signals:
  /// As after `--device`: "sim", "usb:WHICH" or "falcon:WHICH".
  void chosen(const QString& device);
  /// The user wants to choose the Falcon's firmware file.
  void firmwareWanted();

 private:
  void refresh();
  void list(const std::vector<PluggedDevice>& devices, PluggedKind kind, const QString& title);
  void offer(const QString& device, const QString& text, const QString& trouble);

  QActionGroup* group_;
  QString chosen_ = "sim";
  QString firmware_;
};

}  // namespace haptiv
