#include "app/window/operator/DeviceMenu.h"

#include <QActionGroup>

#include "app/window/operator/DeviceText.h"

namespace haptiv {

DeviceMenu::DeviceMenu(DeviceWatch& watch, QWidget* parent)
    : QMenu(tr("D&evice"), parent), watch_(watch), group_(new QActionGroup(this)) {
  setObjectName("deviceMenu");
  setToolTipsVisible(true);
  refresh();
  connect(&watch, &DeviceWatch::changed, this, &DeviceMenu::refresh);
  connect(this, &QMenu::aboutToShow, &watch, &DeviceWatch::look);
}

/// What is chosen stays in the menu, plugged in or not: a session says what is wrong.
void DeviceMenu::refresh() {
  clear();
  offer("sim", tr("Simulated arm"), {}, {});
  listAll();
  addSeparator();
  QAction* firmware = addAction(tr("Falcon's firmware..."));
  firmware->setObjectName("firmwareAction");
  firmware->setToolTip(tr("Choose the firmware file out of the Falcon's driver package; it is remembered"));
  connect(firmware, &QAction::triggered, this, &DeviceMenu::firmwareWanted);
}

void DeviceMenu::listAll() {
  if (!watch_.known()) {
    addAction(lookingForDevices())->setEnabled(false);
  } else if (const auto& [devices, trouble] = *watch_.known(); !trouble.empty()) {
    addAction(QString::fromStdString(trouble))->setEnabled(false);
    if (group_->checkedAction() == nullptr) offer(chosen_, chosenName_, {}, {});
  } else {
    list(devices, PluggedKind::board, tr("Interface boards"));
    list(devices, PluggedKind::falcon, tr("Novint Falcons"));
    list(devices, PluggedKind::spaceMouse, tr("SpaceMice (Hand held by)"));
  }
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
      offer(QString::fromStdString(device.name()), nameTextOf(device), stateTextOf(device), trouble);
    }
  }
  if (group_->checkedAction() == nullptr && chosen_.startsWith(keywordOf(kind) + QString(":"))) {
    offer(chosen_, chosenName_, notPluggedIn(), tr("Plug it in, or choose another device"));
  } else if (!isAny) {
    addAction(tr("None is plugged in"))->setEnabled(false);
  }
}

void DeviceMenu::offer(const QString& device, const QString& name, const QString& state, const QString& trouble) {
  QAction* item = addAction(QString(name + state).replace('&', "&&"));
  item->setObjectName(device + "DeviceAction");
  item->setActionGroup(group_);
  item->setCheckable(true);
  item->setChecked(device == chosen_);
  item->setToolTip(trouble);
  connect(item, &QAction::triggered, this, [this, device, name] {
    chosen_ = device;
    chosenName_ = name;
    emit chosen(device);
  });
}

}  // namespace haptiv

#include "moc_DeviceMenu.cpp"
