// The window's way into calibration and homing: an item of the Control menu, which waits while a session runs.
#include <QDir>
#include <QFileInfo>

#include "app/guide/CalibrationDialog.h"
#include "app/session/Falcons.h"
#include "app/window/MainWindowParts.h"

namespace haptiv {
namespace {

constexpr std::uint64_t kFaultsOfTheSimulatedArm = 1;  // a seed

/// The file that the scene names, or the built-in name.
QString sourceOf(const std::pair<std::string, std::string>& shownDevice) {
  const QString name = QString::fromStdString(shownDevice.second);
  const QFileInfo file(QFileInfo(QString::fromStdString(shownDevice.first)).dir(), name);
  return name.endsWith(".toml") && file.isFile() ? file.absoluteFilePath() : name;
}

}  // namespace

void MainWindow::buildCalibration() {
  Parts& p = *parts_;
  p.control->addSeparator();
  QAction* calibrate = p.control->addAction(tr("Calibrate and home..."));
  calibrate->setObjectName("calibrateAction");
  calibrate->setToolTip(tr("Find the zeros of the encoders, bias and matrix of the handle's sensor, step by step"));
  connect(calibrate, &QAction::triggered, this, &MainWindow::calibrate);
}

void MainWindow::calibrate() {
  if (isFalcon(parts_->device->device().toStdString()))
    return tell(
        tr("A Falcon has no force sensor to be calibrated, and it is homed whenever a session starts. Choose "
           "another device by Session > Device."));
  parts_->devices->pauseThen([this] { openCalibration(); });
}

void MainWindow::openCalibration() {
  const auto open = [device = parts_->device->device().toStdString()](const DeviceDescription& description) {
    return BrakedDevice::named(device, description, kFaultsOfTheSimulatedArm);
  };
  auto* dialog = new CalibrationDialog(parts_->description, sourceOf(parts_->shownDevice), open, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &CalibrationDialog::saved, this, [this] {
    parts_->shownDevice = {};  // it may be the file that the scene names
    showAtRest();
  });
  connect(dialog, &QObject::destroyed, parts_->devices, &DeviceWatch::resume);  // it has let go of the device
  dialog->open();
}

}  // namespace haptiv
