#include "app/guide/CalibrationDialog.h"

#include <QCheckBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSaveFile>
#include <QTimer>
#include <QVBoxLayout>
#include <cmath>
#include <exception>
#include <optional>

#include "app/guide/LiveReadings.h"

namespace haptiv {
namespace {

constexpr int kTick = 1;       // [ms], BrakedDevice::kPeriod
constexpr int kDisplay = 33;   // [ticks] between two pictures of the readings
constexpr int kSettling = 50;  // [ticks] before a measurement begins: a simulated weight comes to rest
constexpr double kUsualTime = 2;
constexpr GuideStep kSteps[] = {GuideStep::pose, GuideStep::bias, GuideStep::loads, GuideStep::finish};

/// Where the description goes unless the user says otherwise: its own file, or one beside the user's own.
QString proposedPath(const QString& source, const QString& name) {
  return QFileInfo(source).isFile() ? QFileInfo(source).absoluteFilePath()
                                    : QDir::home().filePath("my-" + name + ".toml");
}

}  // namespace

struct CalibrationDialog::Parts {
  explicit Parts(const DeviceDescription& description) : guide(description) {}

  CalibrationGuide guide;
  QString source;
  std::optional<BrakedDevice> device;
  std::optional<QuietMeasurement> measurement;
  double seconds = kUsualTime;
  int ticks = 0;
  int settling = 0;

  QTimer timer;
  QLabel *steps, *title, *instruction, *result;
  LiveReadings* readings;
  QCheckBox* anew;
  QProgressBar* progress;
  QLineEdit* path;
  QPushButton *browse, *restart, *skip, *measure, *save, *close;
};

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

void CalibrationDialog::build() {
  Parts& p = *parts_;
  const auto label = [this](const char* name) {
    auto* made = new QLabel(this);
    made->setObjectName(name);
    made->setWordWrap(true);
    return made;
  };
  const auto button = [this](const char* name, const QString& words) {
    auto* made = new QPushButton(words, this);
    made->setObjectName(name);
    made->setAutoDefault(false);
    return made;
  };
  p.steps = label("guideSteps");
  p.steps->setTextFormat(Qt::RichText);
  p.title = label("guideTitle");
  QFont large = p.title->font();
  large.setPointSizeF(1.4 * large.pointSizeF());
  large.setBold(true);
  p.title->setFont(large);
  p.instruction = label("guideInstruction");
  p.result = label("guideResult");
  // Two lines of text have their place all the time: what is below does not jump.
  p.instruction->setMinimumHeight(2 * fontMetrics().lineSpacing() + 4);
  p.instruction->setAlignment(Qt::AlignTop);
  p.result->setMinimumHeight(3 * fontMetrics().lineSpacing() + 4);
  p.result->setAlignment(Qt::AlignTop);
  p.readings = new LiveReadings(this);
  p.anew = new QCheckBox(tr("No zero was known, or the encoders have lost power: take any counts"), this);
  p.anew->setObjectName("guideAnew");
  p.progress = new QProgressBar(this);
  p.progress->setObjectName("guideProgress");
  p.progress->setRange(0, 1000);
  p.path = new QLineEdit(this);
  p.path->setObjectName("guidePath");
  p.browse = button("guideBrowse", tr("Browse..."));
  p.restart = button("guideRestart", tr("Begin anew"));
  p.skip = button("guideSkip", tr("Skip"));
  p.measure = button("guideMeasure", tr("Measure"));
  p.save = button("guideSave", tr("Save"));
  p.close = button("guideClose", tr("Close"));

  auto* file = new QHBoxLayout;
  file->addWidget(p.path);
  file->addWidget(p.browse);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(p.restart);
  buttons->addStretch();
  for (QPushButton* each : {p.skip, p.measure, p.save, p.close}) buttons->addWidget(each);
  auto* page = new QVBoxLayout;
  page->addWidget(p.title);
  page->addWidget(p.instruction);
  page->addWidget(p.anew);
  page->addLayout(file);
  page->addWidget(p.readings, 1);
  page->addWidget(p.progress);
  page->addWidget(p.result);
  page->addLayout(buttons);
  p.steps->setMinimumWidth(160);
  p.steps->setAlignment(Qt::AlignTop);
  auto* all = new QHBoxLayout(this);
  all->addWidget(p.steps);
  all->addLayout(page, 1);
}

void CalibrationDialog::connectParts() {
  Parts& p = *parts_;
  connect(p.measure, &QPushButton::clicked, this, &CalibrationDialog::startMeasuring);
  connect(p.skip, &QPushButton::clicked, this, [this] {
    parts_->guide.skip();
    tell({}, false);
    showStep();
  });
  connect(p.restart, &QPushButton::clicked, this, [this] {
    parts_->guide.restart();
    tell({}, false);
    showStep();
  });
  connect(p.browse, &QPushButton::clicked, this, [this] {
    const QString chosen = QFileDialog::getSaveFileName(this, tr("Save the device description"), parts_->path->text(),
                                                        tr("TOML (*.toml)"));
    if (!chosen.isEmpty()) parts_->path->setText(chosen);
  });
  connect(p.save, &QPushButton::clicked, this, &CalibrationDialog::save);
  connect(p.close, &QPushButton::clicked, this, &QDialog::reject);
  connect(&p.timer, &QTimer::timeout, this, &CalibrationDialog::tick);
}

void CalibrationDialog::openDevice(const DeviceOpener& open) {
  Parts& p = *parts_;
  try {
    p.device.emplace(open(p.guide.calibration().description()));
  } catch (const std::exception& error) {
    tell(QString::fromUtf8(error.what()), true);
    p.measure->setEnabled(false);
    p.skip->setEnabled(false);
    return;
  }
  setWindowTitle(windowTitle() + (p.device->isSimulated() ? tr(": a simulated arm, not quite as described")
                                                          : tr(": the interface board")));
  p.timer.setTimerType(Qt::PreciseTimer);
  p.timer.start(kTick);
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
  for (QPushButton* each : {p.measure, p.skip, p.restart}) each->setEnabled(!measuring);
  p.anew->setEnabled(!measuring);
  p.save->setEnabled(p.guide.calibration().isChanged());
  if (!measuring) p.progress->setValue(0);
  if (atEnd && p.result->text().isEmpty()) tell(QString::fromStdString(p.guide.summary()), false);
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
