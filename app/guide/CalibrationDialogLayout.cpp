// What stands where in the dialog, and what its buttons do. What it does meanwhile is in CalibrationDialog.cpp.
#include <QFileDialog>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "app/guide/CalibrationDialogParts.h"

namespace haptiv {

void CalibrationDialog::build() {
  makeWords();
  makeControls();
  arrange();
}

void CalibrationDialog::makeWords() {
  Parts& p = *parts_;
  const auto label = [this](const char* name) {
    auto* made = new QLabel(this);
    made->setObjectName(name);
    made->setWordWrap(true);
    return made;
  };
  p.steps = label("guideSteps");
  p.steps->setTextFormat(Qt::RichText);
  p.steps->setMinimumWidth(160);
  p.steps->setAlignment(Qt::AlignTop);
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
}

// The Tab key goes through them in this order.
void CalibrationDialog::makeControls() {
  Parts& p = *parts_;
  const auto button = [this](const char* name, const QString& words) {
    auto* made = new QPushButton(words, this);
    made->setObjectName(name);
    made->setAutoDefault(false);
    return made;
  };
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
  p.loads = button("guideLoads", tr("Other loads..."));
  p.loads->setToolTip(tr("Say what you have to hang on the handle"));
  p.skip = button("guideSkip", tr("Skip"));
  p.measure = button("guideMeasure", tr("Measure"));
  p.save = button("guideSave", tr("Save"));
  p.close = button("guideClose", tr("Close"));
}

void CalibrationDialog::arrange() {
  Parts& p = *parts_;
  auto* file = new QHBoxLayout;
  file->addWidget(p.path);
  file->addWidget(p.browse);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(p.restart);
  buttons->addStretch();
  buttons->addWidget(p.loads);
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
  auto* all = new QHBoxLayout(this);
  all->addWidget(p.steps);
  all->addLayout(page, 1);
}

void CalibrationDialog::connectParts() {
  Parts& p = *parts_;
  connect(p.measure, &QPushButton::clicked, this, &CalibrationDialog::startMeasuring);
  connect(p.loads, &QPushButton::clicked, this, &CalibrationDialog::chooseLoads);
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
  connect(&p.timer, &QTimer::timeout, this, &CalibrationDialog::catchUp);
}

}  // namespace haptiv
