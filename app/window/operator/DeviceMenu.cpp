#include "app/window/operator/DeviceMenu.h"

#include <QActionGroup>
#include <exception>

#include "app/window/operator/DeviceText.h"

namespace haptiv {

DeviceMenu::DeviceMenu(QWidget* parent) : QMenu(tr("D&evice"), parent), group_(new QActionGroup(this)) {
  setObjectName("deviceMenu");
  setToolTipsVisible(true);
  offer("sim", tr("Simulated arm"), {});
  connect(this, &QMenu::aboutToShow, this, &DeviceMenu::refresh);
}

/// What is chosen stays in the menu, plugged in or not: a session says what is wrong.
void DeviceMenu::refresh() {
  clear();
  offer("sim", tr("Simulated arm"), {});
  try {
    const std::vector<PluggedDevice> devices = pluggedDevices(firmware_.toStdString());
    list(devices, PluggedKind::board, tr("Interface boards"));
    list(devices, PluggedKind::falcon, tr("Novint Falcons"));
    list(devices, PluggedKind::spaceMouse, tr("SpaceMice (Hand held by)"));
  } catch (const std::exception& error) {
    addAction(QString::fromUtf8(error.what()))->setEnabled(false);
  }
  if (group_->checkedAction() == nullptr)
    offer(chosen_, chosen_.section(':', 1) + notPluggedIn(), tr("Plug it in, or choose another device"));
  addSeparator();
  QAction* firmware = addAction(tr("Falcon's firmware..."));
  firmware->setObjectName("firmwareAction");
  firmware->setToolTip(tr("Choose the firmware file out of the Falcon's driver package; it is remembered"));
  connect(firmware, &QAction::triggered, this, &DeviceMenu::firmwareWanted);
}

void DeviceMenu::list(const std::vector<PluggedDevice>& devices, PluggedKind kind, const QString& title) {
  addSection(title);
  bool isAny = false;
  for (const PluggedDevice& device : devices) {
    if (device.kind != kind) continue;
    isAny = true;
    const QString trouble = QString::fromStdString(device.trouble);
    if (kind == PluggedKind::spaceMouse) {
      addAction(textOf(device))->setEnabled(false);
    } else {
      offer(QString::fromStdString(device.name()), textOf(device), trouble);
    }
  }
  if (!isAny) addAction(tr("None is plugged in"))->setEnabled(false);
}

void DeviceMenu::offer(const QString& device, const QString& text, const QString& trouble) {
  QAction* item = addAction(text);
  item->setObjectName(device + "DeviceAction");
  item->setActionGroup(group_);
  item->setCheckable(true);
  item->setChecked(device == chosen_);
  item->setToolTip(trouble);
  connect(item, &QAction::triggered, this, [this, device] { emit chosen(chosen_ = device); });
}

}  // namespace haptiv
