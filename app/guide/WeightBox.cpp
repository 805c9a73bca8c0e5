#include "app/guide/WeightBox.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

namespace haptiv {
namespace {

constexpr double kHeaviest = 50, kFarthest = 2;  // [kg], [m]

/// In the order of the combo box: -z, +z, -x ...
Vector3 axisOf(int index) {
  constexpr std::array kAxes = {2, 0, 1};
  return (index % 2 == 0 ? -1 : 1) * Vector3::Unit(kAxes[static_cast<std::size_t>(index / 2)]);
}

}  // namespace

WeightBox::WeightBox(QWidget* parent) : QGroupBox(tr("A weight"), parent) {
  mass_ = number("weightMass", 0.001, kHeaviest, 3, 0.1);
  mass_->setValue(1);
  down_ = new QComboBox(this);
  down_->setObjectName("weightDown");
  down_->addItems({tr("against z"), tr("along z"), tr("against x"), tr("along x"), tr("against y"), tr("along y")});
  down_->setToolTip(tr("Which way is down, in the handle's axes: turn the handle for each"));
  auto* rows = new QFormLayout(this);
  rows->addRow(tr("mass [kg]"), mass_);
  rows->addRow(tr("pulls"), down_);
  constexpr std::array kNames = {"x", "y", "z"};
  for (std::size_t i = 0; i < place_.size(); ++i) {
    const QString axis = kNames[i];
    place_[i] = number(("weightPlace" + axis).toLatin1().constData(), -kFarthest, kFarthest, 4, 0.01);
    place_[i]->setToolTip(tr("Where it hangs, from the tool, in the handle's axes"));
    rows->addRow(tr("at %1 [m]").arg(axis), place_[i]);
  }
  load_ = new QLabel(this);
  load_->setObjectName("weightLoad");
  rows->addRow(load_);
  auto* add = new QPushButton(tr("Add this weight"), this);
  add->setObjectName("weightAdd");
  add->setAutoDefault(false);
  rows->addRow(add);
  connect(down_, qOverload<int>(&QComboBox::currentIndexChanged), this, &WeightBox::showLoad);
  for (QDoubleSpinBox* each : findChildren<QDoubleSpinBox*>())
    connect(each, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &WeightBox::showLoad);
  connect(add, &QPushButton::clicked, this, [this] { emit added(weight()); });
  showLoad();
}

QDoubleSpinBox* WeightBox::number(const char* name, double low, double high, int decimals, double step) {
  auto* box = new QDoubleSpinBox(this);
  box->setObjectName(name);
  box->setRange(low, high);
  box->setDecimals(decimals);
  box->setSingleStep(step);
  return box;
}

HungWeight WeightBox::weight() const {
  return {mass_->value(), axisOf(down_->currentIndex()),
          Vector3(place_[0]->value(), place_[1]->value(), place_[2]->value())};
}

void WeightBox::showLoad() {
  const Vector6 load = loadOf(weight());
  load_->setText(tr("%1 N, %2 N m").arg(load.head<3>().norm(), 0, 'f', 2).arg(load.tail<3>().norm(), 0, 'f', 3));
}

}  // namespace haptiv

#include "moc_WeightBox.cpp"
