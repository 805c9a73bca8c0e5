#pragma once

#include <QMenu>
#include <vector>

#include "app/window/operator/DeviceWatch.h"

class QActionGroup;

namespace haptiv {

/// The menu by which the user chooses the arm of the next session: the simulated one, an interface board or a Falcon
/// that is plugged in. It shows what the watch knows and, open or not, follows it; SpaceMice too, which are chosen
/// elsewhere. Thread: GUI.
class DeviceMenu : public QMenu {
  Q_OBJECT
 public:
  /// @param watch  is there as long as this is used
  explicit DeviceMenu(DeviceWatch& watch, QWidget* parent = nullptr);

  /// What is chosen, as after `--device`.
  const QString& device() const { return chosen_; }

 signals:
  /// As after `--device`: "sim", "usb:WHICH" or "falcon:WHICH".
  void chosen(const QString& device);
  /// The user wants to choose the Falcon's firmware file.
  void firmwareWanted();

 private:
  void refresh();
  void listAll();
  void list(const std::vector<PluggedDevice>& devices, PluggedKind kind, const QString& title);
  void offer(const QString& device, const QString& name, const QString& state, const QString& trouble);

  DeviceWatch& watch_;
  QActionGroup* group_;
  QString chosen_ = "sim";
  QString chosenName_;  // what it is called
};

}  // namespace haptiv
