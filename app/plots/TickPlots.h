#pragma once

#include <array>
#include <vector>

#include "app/plots/SignalPlot.h"
#include "haptics/tick/TickRecord.h"

namespace haptiv {

/// The two plots that a session and its replay show: "forcePlot", the norms of the environment's and the hand's force
/// on the ball, and "positionPlot", the ball in W.
SignalPlot* makeForcePlot(QWidget* parent);
SignalPlot* makePositionPlot(QWidget* parent);

/// A sample for the force plot: environment, hand [N].
std::array<double, 2> forceSample(const TickRecord& record);
/// A sample for the position plot: x, y, z of p_WT from the joint angles [m].
std::array<double, 3> positionSample(const TickRecord& record);
/// Since the session's start [s].
double secondsOf(const TickRecord& record);

}  // namespace haptiv
