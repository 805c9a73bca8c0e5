#pragma once

#include "app/bench/wall/WallMap.h"
#include "app/figures/Figure.h"

namespace haptiv {

/// A panel a grip: damping against stiffness, both logarithmic; how the law's wall shakes as colours, the limits of all
/// variants and the optimal stiffness (33) as lines.
Figure wallFigure(const WallMap& map);

}  // namespace haptiv
