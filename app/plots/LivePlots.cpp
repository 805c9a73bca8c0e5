#include "app/plots/LivePlots.h"

#include <QHBoxLayout>

namespace haptiv {

LivePlots::LivePlots(QWidget* parent)
    : QWidget(parent), force_(makeForcePlot(this)), position_(makePositionPlot(this)) {
  force_->setEmptyText("Start a session to see the force");
  position_->setEmptyText("Start a session to see the ball's position");
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(force_, 1);
  layout->addWidget(position_, 1);
}

void LivePlots::append(const TickRecord& record) {
  const auto force = forceSample(record);
  const auto position = positionSample(record);
  force_->append(secondsOf(record), {force.begin(), force.end()});
  position_->append(secondsOf(record), {position.begin(), position.end()});
}

void LivePlots::clear() {
  force_->clear();
  position_->clear();
}

}  // namespace haptiv
