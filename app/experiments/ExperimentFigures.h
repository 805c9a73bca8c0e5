#pragma once

#include <string>
#include <vector>

#include "app/experiments/RunTable.h"
#include "app/figures/Figure.h"
#include "device/described/DeviceDescription.h"

namespace haptiv {

struct NamedFigure {
  std::string name;  ///< of its file, such as fig10-circle-full-r0.80
  Figure figure;
};

/// The paper's figures 10 to 18, as far as there are runs for them. Indices are divided by the table's scale.
std::vector<NamedFigure> experimentFigures(const RunTable& table, const DeviceDescription& device);

}  // namespace haptiv
