#pragma once

#include <array>
#include <vector>

#include "app/plots/SignalPlot.h"
#include "haptics/tick/TickRecord.h"

namespace haptiv {

/// The plots that a session and its replay show: "forcePlot", the norms of the environment's and the hand's force
/// on the ball, "positionPlot", the ball in W, and "energyPlot", what the passivity observer has counted: below zero
/// the display has given more than it has taken.
SignalPlot* makeForcePlot(QWidget* parent);
SignalPlot* makePositionPlot(QWidget* parent);
SignalPlot* makeEnergyPlot(QWidget* parent);

/// A sample for the force plot: environment, hand [N].
std::array<double, 2> forceSample(const TickRecord& record);
/// A sample for the position plot: x, y, z of p_WT from the joint angles [m].
std::array<double, 3> positionSample(const TickRecord& record);
/// A sample for the energy plot [J].
std::array<double, 1> energySample(const TickRecord& record);
/// Since the session's start [s].
double secondsOf(const TickRecord& record);

}  // namespace haptiv
