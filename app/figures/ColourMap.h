#pragma once

#include <utility>

#include "app/figures/Figure.h"

class QwtPlot;

namespace haptiv {

/// What the colours of a map mean: its range, or from its least to its greatest value.
std::pair<double, double> colourRange(const FigureMap& map);

/// Adds the map's colours to a plot, and a bar to the axis at its right, which is to be set up to colourRange.
void addColours(QwtPlot& plot, const FigureMap& map);

}  // namespace haptiv
