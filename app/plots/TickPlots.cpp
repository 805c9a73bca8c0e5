#include "app/plots/TickPlots.h"

namespace haptiv {

namespace {

constexpr double kMinimumForceSpan = 1;        // [N]; the sensor's noise is a few hundredths of it
constexpr double kMinimumPositionSpan = 0.02;  // [m]
constexpr double kMinimumEnergySpan = 0.01;    // [J]; the observer's reserve is a tenth of it

}  // namespace

SignalPlot* makeForcePlot(QWidget* parent) {
  auto* plot = new SignalPlot("Force [N]", {"environment", "hand"}, parent);
  plot->setObjectName("forcePlot");
  plot->setMinimumSpan(kMinimumForceSpan);
  return plot;
}

SignalPlot* makePositionPlot(QWidget* parent) {
  auto* plot = new SignalPlot("Position [m]", {"x", "y", "z"}, parent);
  plot->setObjectName("positionPlot");
  plot->setMinimumSpan(kMinimumPositionSpan);
  return plot;
}

SignalPlot* makeEnergyPlot(QWidget* parent) {
  auto* plot = new SignalPlot("Passivity [J]", {"energy taken"}, parent);
  plot->setObjectName("energyPlot");
  plot->setMinimumSpan(kMinimumEnergySpan);
  return plot;
}

std::array<double, 2> forceSample(const TickRecord& record) {
  return {record.environmentForce.norm(), record.handForce.norm()};
}

std::array<double, 3> positionSample(const TickRecord& record) {
  return {record.position.x(), record.position.y(), record.position.z()};
}

std::array<double, 1> energySample(const TickRecord& record) {
  return {record.passivityEnergy};
}

double secondsOf(const TickRecord& record) {
  return static_cast<double>(record.time) * 1e-9;
}

}  // namespace haptiv
