#include "app/plots/LivePlots.h"

#include <QHBoxLayout>

namespace haptiv {

LivePlots::LivePlots(QWidget* parent)
    : QWidget(parent), force_(makeForcePlot(this)), position_(makePositionPlot(this)), energy_(makeEnergyPlot(this)) {
  force_->setEmptyText("Start a session to see the force");
  position_->setEmptyText("Start a session to see the ball's position");
  energy_->setEmptyText("Start a session to see the energy");
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(force_, 1);
  layout->addWidget(position_, 1);
  layout->addWidget(energy_, 1);
}

void LivePlots::append(const TickRecord& record) {
  const auto force = forceSample(record);
  const auto position = positionSample(record);
  const auto energy = energySample(record);
  force_->append(secondsOf(record), {force.begin(), force.end()});
  position_->append(secondsOf(record), {position.begin(), position.end()});
  energy_->append(secondsOf(record), {energy.begin(), energy.end()});
}

void LivePlots::clear() {
  force_->clear();
  position_->clear();
  energy_->clear();
}

}  // namespace haptiv

#include "moc_LivePlots.cpp"
