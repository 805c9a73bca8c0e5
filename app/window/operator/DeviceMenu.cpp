#include "app/window/operator/DeviceMenu.h"

#include <QActionGroup>
#include <exception>

#include "device/usb/host/BoardList.h"

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
  addSection(tr("Interface boards"));
  bool isChosenThere = chosen_ == "sim";
  try {
    const std::vector<usb::ListedBoard> boards = usb::listBoards();
    for (const usb::ListedBoard& board : boards) {
      const QString device = "usb:" + QString::fromStdString(board.serial);
      offer(device, QString::fromStdString(board.product + " " + board.serial), QString::fromStdString(board.trouble));
      isChosenThere = isChosenThere || device == chosen_;
    }
    if (boards.empty()) addAction(tr("None is plugged in"))->setEnabled(false);
  } catch (const std::exception& error) {
    addAction(QString::fromUtf8(error.what()))->setEnabled(false);
  }
  if (!isChosenThere) offer(chosen_, chosen_.mid(4), tr("It is not plugged in"));
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
