#pragma once

#include "app/figures/Figure.h"
#include "device/described/DeviceDescription.h"

namespace haptiv {

/// Figure 14: the path of experiment 2, the workspace and the arm at the start, from above.
Figure trajectoryFigure(const DeviceDescription& device);

}  // namespace haptiv
