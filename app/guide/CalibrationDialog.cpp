#include "app/guide/CalibrationDialog.h"

#include <QDir>
#include <QFileInfo>
#include <QSaveFile>
#include <algorithm>
#include <cmath>
#include <exception>

#include "app/guide/CalibrationDialogParts.h"
#include "app/guide/LoadsDialog.h"

namespace haptiv {
namespace {

constexpr int kTick = 1;         // [ms], BrakedDevice::kPeriod
constexpr int kDisplay = 33;     // [ticks] between two pictures of the readings
constexpr int kSettling = 50;    // [ticks] before a measurement begins: a simulated weight comes to rest
constexpr int kMostAtOnce = 20;  // ticks of one event
constexpr GuideStep kSteps[] = {GuideStep::pose, GuideStep::bias, GuideStep::loads, GuideStep::finish};

/// Where the description goes unless the user says otherwise: its own file, or one beside the user's own.
QString proposedPath(const QString& source, const QString& name) {
  return QFileInfo(source).isFile() ? QFileInfo(source).absoluteFilePath()
                                    : QDir::home().filePath("my-" + name + ".toml");
}

}  // namespace

CalibrationDialog::CalibrationDialog(const DeviceDescription& description, const QString& source,
                                     const DeviceOpener& open, QWidget* parent)
    : QDialog(parent), parts_(std::make_unique<Parts>(description)) {
  parts_->source = source;
  setObjectName("calibrationDialog");
  setWindowTitle(tr("Calibrate and home %1").arg(QString::fromStdString(description.name)));
  resize(900, 600);
  build();
  parts_->path->setText(proposedPath(source, QString::fromStdString(description.name)));
  connectParts();
  showStep();
  openDevice(open);
}

CalibrationDialog::~CalibrationDialog() = default;

void CalibrationDialog::setMeasuringTime(double seconds) {
  parts_->seconds = seconds;
}

void CalibrationDialog::openDevice(const DeviceOpener& open) {
  Parts& p = *parts_;
  try {
    p.device.emplace(open(p.guide.calibration().description()));
  } catch (const std::exception& error) {
    tell(QString::fromUtf8(error.what()), true);
    for (QPushButton* each : {p.measure, p.skip, p.restart}) each->setEnabled(false);
    return;
  }
  setWindowTitle(windowTitle() + (p.device->isSimulated() ? tr(": a simulated arm, not quite as described")
                                                          : tr(": the interface board")));
  p.timer.setTimerType(Qt::PreciseTimer);
  p.sinceTick.start();
  p.timer.start(kTick);
}

/// The timer comes late on a busy machine: a simulated arm makes up for it, any other has no new reading.
void CalibrationDialog::catchUp() {
  const qint64 due = parts_->sinceTick.restart();
  const qint64 ticks = parts_->device->isSimulated() ? std::clamp<qint64>(due, 1, kMostAtOnce) : 1;
  for (qint64 i = 0; i < ticks; ++i) tick();
}

void CalibrationDialog::tick() {
  Parts& p = *parts_;
  if (LoadedHandle* handle = p.device->handle()) handle->hang(p.guide.load());
  const DeviceReading reading = p.device->tick();
  if (++p.ticks % kDisplay == 0) p.readings->show(p.guide.calibration().description(), reading);
  if (!p.measurement) return;
  if (p.settling > 0) {
    --p.settling;
    return;
  }
  p.measurement->take(reading);
  p.progress->setValue(static_cast<int>(1000 * p.measurement->progress()));
  if (p.measurement->isDone()) finishMeasuring();
}

void CalibrationDialog::startMeasuring() {
  Parts& p = *parts_;
  tell({}, false);
  p.measurement.emplace(std::llround(p.seconds / BrakedDevice::kPeriod));
  p.settling = kSettling;
  showStep();
}

void CalibrationDialog::finishMeasuring() {
  Parts& p = *parts_;
  const QuietMeasurement measured = *p.measurement;
  p.measurement.reset();
  try {
    if (p.device->isLost()) {  // encoders that count from anywhere are told first, then measured
      p.device->findAgain(measured, p.guide.calibration().description());
      return startMeasuring();
    }
    tell(QString::fromStdString(p.guide.take(measured, p.anew->isChecked())), false);
  } catch (const std::exception& refused) {
    tell(QString::fromUtf8(refused.what()), true);
  }
  showStep();
}

void CalibrationDialog::tell(const QString& what, bool refused) {
  QPalette palette = this->palette();
  if (refused) palette.setColor(QPalette::WindowText, QColor(190, 30, 30));
  parts_->result->setPalette(palette);
  parts_->result->setText(what.isEmpty() ? what : what.left(1).toUpper() + what.mid(1));
}

void CalibrationDialog::showSteps() {
  QString rows;
  for (const GuideStep step : kSteps) {
    if (!parts_->guide.has(step)) continue;
    const bool here = step == parts_->guide.step();
    const QString mark = parts_->guide.isDone(step) ? "&#10003;" : here ? "&#9654;" : "&#9675;";
    const QString name = tr(nameOf(step));
    rows += QString("<p>%1&nbsp; %2</p>").arg(mark, here ? "<b>" + name + "</b>" : name);
  }
  parts_->steps->setText(rows);
}

void CalibrationDialog::showStep() {
  Parts& p = *parts_;
  const GuideStep step = p.guide.step();
  const bool atEnd = step == GuideStep::finish, measuring = p.measurement.has_value();
  showSteps();
  p.title->setText(QString::fromStdString(p.guide.title()));
  p.instruction->setText(QString::fromStdString(p.guide.instruction()));
  p.anew->setVisible(step == GuideStep::pose);
  for (QWidget* each : {static_cast<QWidget*>(p.path), static_cast<QWidget*>(p.browse), static_cast<QWidget*>(p.save)})
    each->setVisible(atEnd);
  for (QWidget* each :
       {static_cast<QWidget*>(p.measure), static_cast<QWidget*>(p.skip), static_cast<QWidget*>(p.progress)})
    each->setVisible(!atEnd);
  p.loads->setVisible(step == GuideStep::loads);
  for (QPushButton* each : {p.measure, p.loads, p.skip, p.restart}) each->setEnabled(!measuring);
  p.anew->setEnabled(!measuring);
  p.save->setEnabled(p.guide.calibration().isChanged());
  if (!measuring) p.progress->setValue(0);
  if (atEnd && p.result->text().isEmpty()) tell(QString::fromStdString(p.guide.summary()), false);
}

void CalibrationDialog::chooseLoads() {
  Parts& p = *parts_;
  auto* dialog = new LoadsDialog(p.guide.calibration().description().sensor, p.guide.loads(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    parts_->guide.setLoads(dialog->loads());
    tell({}, false);
    showStep();
  });
  dialog->open();
}

void CalibrationDialog::save() {
  Parts& p = *parts_;
  try {
    const std::string text = p.guide.calibration().text(p.source.toStdString());
    QSaveFile file(p.path->text());
    const bool written =
        file.open(QIODevice::WriteOnly) &&
        file.write(text.data(), static_cast<qint64>(text.size())) == static_cast<qint64>(text.size()) && file.commit();
    if (!written) {
      tell(tr("%1: cannot be written: %2. Choose another file").arg(p.path->text(), file.errorString()), true);
      return;
    }
  } catch (const std::exception& error) {
    tell(QString::fromUtf8(error.what()), true);
    return;
  }
  tell(tr("Saved. A scene uses it by: HapticDevice { description \"%1\" }").arg(p.path->text()), false);
  emit saved(p.path->text());
}

}  // namespace haptiv

#include "moc_CalibrationDialog.cpp"
