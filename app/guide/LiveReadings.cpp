#include "app/guide/LiveReadings.h"

#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <cmath>

#include "device/calibration/QuietCheck.h"

namespace haptiv {
namespace {

constexpr double kBarOfRange = 0.1;  // of the sensor's range fills a bar

QLabel* numberLabel(const QString& name, QWidget* parent) {
  auto* label = new QLabel("-", parent);
  label->setObjectName(name);
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  label->setMinimumWidth(label->fontMetrics().horizontalAdvance("-000.0000 N m"));  // numbers change, the layout not
  return label;
}

/// Without the sign of a nought.
QString fixed(double value, int decimals) {
  const double unit = std::pow(10, decimals);
  return QString::number(std::round(value * unit) / unit + 0.0, 'f', decimals);
}

}  // namespace

LiveReadings::LiveReadings(QWidget* parent) : QWidget(parent) {
  auto* sensor = new QGroupBox(tr("Handle's sensor, as calibrated"), this);
  auto* sensorRows = new QGridLayout(sensor);
  for (int i = 0; i < 6; ++i) {
    const auto at = static_cast<std::size_t>(i);
    axes_[at] = numberLabel(QString("axis%1").arg(i + 1), sensor);
    bars_[at] = new SignedBar(sensor);
    sensorRows->addWidget(new QLabel(nameOfAxis(i), sensor), i, 0);
    sensorRows->addWidget(bars_[at], i, 1);
    sensorRows->addWidget(axes_[at], i, 2);
  }
  sensorRows->setRowStretch(6, 1);
  sensorRows->setColumnStretch(1, 1);
  auto* joints = new QGroupBox(tr("Joints"), this);
  auto* jointRows = new QGridLayout(joints);
  jointRows->setVerticalSpacing(2);
  jointRows->addWidget(new QLabel(tr("angle"), joints), 0, 1, Qt::AlignRight);
  jointRows->addWidget(new QLabel(tr("off the pose"), joints), 0, 2, Qt::AlignRight);
  for (int i = 0; i < kJointCount; ++i) {
    const auto at = static_cast<std::size_t>(i);
    angles_[at] = numberLabel(QString("angle%1").arg(i + 1), joints);
    offsets_[at] = numberLabel(QString("offset%1").arg(i + 1), joints);
    jointRows->addWidget(new QLabel(tr("joint %1").arg(i + 1), joints), i + 1, 0);
    jointRows->addWidget(angles_[at], i + 1, 1);
    jointRows->addWidget(offsets_[at], i + 1, 2);
  }
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(sensor, 3);
  row->addWidget(joints, 2);
}

void LiveReadings::show(const DeviceDescription& description, const DeviceReading& reading) {
  const Wrench wrench = description.handleWrench(reading);
  Vector6 values;
  values << wrench.force, wrench.torque;
  const Vector6 shares = values.cwiseQuotient(kBarOfRange * description.sensor.range());
  for (int i = 0; i < 6; ++i) {
    const auto at = static_cast<std::size_t>(i);
    axes_[at]->setText(fixed(values[i], i < 3 ? 2 : 3) + (i < 3 ? tr(" N") : tr(" N m")));
    bars_[at]->setShare(shares[i]);
  }
  const JointVector angles = description.jointAngles(reading);
  const JointVector off = angles - description.encoders.reference;
  for (int i = 0; i < description.jointCount(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    angles_[at]->setText(fixed(angles[i], 4) + tr(" rad"));
    offsets_[at]->setText(fixed(off[i], 4) + tr(" rad"));
  }
}

}  // namespace haptiv

#include "moc_LiveReadings.cpp"
