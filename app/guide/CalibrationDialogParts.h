#pragma once

#include <QCheckBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <optional>

#include "app/guide/CalibrationDialog.h"
#include "app/guide/LiveReadings.h"

namespace haptiv {

/// What the dialog is made of. Private to CalibrationDialog's sources.
struct CalibrationDialog::Parts {
  explicit Parts(const DeviceDescription& description) : guide(description) {}

  CalibrationGuide guide;
  QString source;
  std::optional<BrakedDevice> device;
  std::optional<QuietMeasurement> measurement;
  double seconds = 2;  // of a measurement
  int ticks = 0;
  int settling = 0;

  QTimer timer;
  QElapsedTimer sinceTick;
  QLabel *steps, *title, *instruction, *result;
  LiveReadings* readings;
  QCheckBox* anew;
  QProgressBar* progress;
  QLineEdit* path;
  QPushButton *browse, *restart, *loads, *skip, *measure, *save, *close;
};

}  // namespace haptiv
