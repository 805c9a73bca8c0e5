// The window's way to the devices that are plugged in: which is chosen, how a Falcon comes to be ready.
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <exception>

#include "app/window/MainWindowParts.h"
#include "device/usb/falcon/FalconFirmware.h"

namespace haptiv {

void MainWindow::connectDevices() {
  Parts& p = *parts_;
  connect(p.start, &QAction::triggered, this, &MainWindow::startSession);
  connect(p.device, &DeviceMenu::chosen, p.session, &SessionControl::chooseDevice);
  connect(p.device, &DeviceMenu::chosen, this, &MainWindow::showOperator);
  connect(p.device, &DeviceMenu::firmwareWanted, this, &MainWindow::chooseFirmware);
  connect(p.devices, &DeviceWatch::told, this, [this](const QString& what) {
    constexpr int kWhile = 6000;  // [ms]
    parts_->status->showMessage(what, kWhile);
  });
  connect(p.heldBy, &HandMenu::chosen, p.session, &SessionControl::chooseHand);
  connect(p.heldBy, &HandMenu::chosen, this, &MainWindow::showOperator);
  for (QMenu* menu : std::initializer_list<QMenu*>{p.control, p.device, p.heldBy}) {
    connect(p.session, &SessionControl::started, menu, [menu] { menu->setEnabled(false); });
    connect(p.session, &SessionControl::stopped, menu, [menu] { menu->setEnabled(true); });
  }
  connect(p.session, &SessionControl::stopped, p.devices, &DeviceWatch::resume);
  connect(p.session, &SessionControl::failed, this, &MainWindow::watchDevices);
}

/// Unless a session holds them.
void MainWindow::watchDevices() {
  if (!parts_->session->isRunning()) parts_->devices->resume();
}

void MainWindow::showOperator() {
  const Parts& p = *parts_;
  using By = SessionStatus::HandBy;
  p.status->setHandBy(p.device->device() != "sim" ? By::device : p.heldBy->isMouse() ? By::mouse : By::spaceMouse);
}

void MainWindow::startSession() {
  parts_->devices->pauseThen([this] {
    Parts& p = *parts_;
    if (p.replay) return watchDevices();  // a log was opened meanwhile
    p.status->clearMessage();             // it would hide the session's state
    if (!isFalcon(p.device->device().toStdString())) return p.session->start();
    if (const auto description = p.session->descriptionNeeded()) openFalcon(*description);
  });
}

/// Meanwhile the window waits behind a dialog that says what to do; cancelled, all is as before.
void MainWindow::openFalcon(const DeviceDescription& description) {
  Parts& p = *parts_;
  const FalconChoice choice = falconChoiceOf(p.device->device().toStdString(), p.firmware.toStdString());
  auto* dialog = new QProgressDialog(tr("Setting up the Falcon..."), tr("Cancel"), 0, 0, this);
  dialog->setObjectName("falconDialog");
  dialog->setWindowTitle(tr("Falcon"));
  dialog->setWindowModality(Qt::WindowModal);
  auto* opening = new FalconOpening(description, choice, 1 / p.session->rate(), dialog);
  const auto end = [this, dialog] {
    dialog->hide();
    dialog->deleteLater();
    parts_->start->setEnabled(true);
  };
  connect(dialog, &QProgressDialog::canceled, opening, &FalconOpening::cancel);
  connect(opening, &FalconOpening::told, dialog, &QProgressDialog::setLabelText);
  connect(opening, &FalconOpening::cancelled, this, [this, end] {
    end();
    watchDevices();
  });
  connect(opening, &FalconOpening::opened, this, [this, end, opening] {
    end();
    parts_->session->startWith(opening->take());
  });
  connect(opening, &FalconOpening::failed, this, [this, end](const QString& why) {
    end();
    watchDevices();
    tellOfFalcon(why);
  });
  p.start->setEnabled(false);
  dialog->show();
}

/// Where it is the firmware that is wrong, the way to another one is a button.
void MainWindow::tellOfFalcon(const QString& why) {
  auto* box = new QMessageBox(QMessageBox::Warning, tr("Haptiv"), why, QMessageBox::Close, this);
  box->setObjectName("messageBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  const QString firmware = parts_->firmware;
  try {
    falcon::readFirmware(firmware.isEmpty() ? falcon::firmwarePath() : firmware.toStdString());
  } catch (const std::exception&) {
    QPushButton* choose = box->addButton(tr("Choose the firmware..."), QMessageBox::AcceptRole);
    choose->setObjectName("chooseFirmware");
    connect(choose, &QPushButton::clicked, this, &MainWindow::chooseFirmware);
  }
  box->open();
}

void MainWindow::chooseFirmware() {
  auto* dialog =
      new QFileDialog(this, tr("The Falcon's firmware file"), QString(), tr("Firmware (*.bin *.BIN);;All (*)"));
  dialog->setObjectName("firmwareDialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::keepFirmware);
  dialog->open();
}

/// A wrong file changes nothing: what was remembered before stays.
void MainWindow::keepFirmware(const QString& path) {
  Parts& p = *parts_;
  try {
    p.firmware = QString::fromStdString(falcon::keepFirmware(path.toStdString()));
    p.devices->setFirmware(p.firmware);
    p.status->showMessage(tr("The Falcon's firmware is kept as %1").arg(p.firmware), 4'000);
  } catch (const std::exception& error) {
    tell(QString::fromUtf8(error.what()));
  }
}

}  // namespace haptiv
