#pragma once

#include <cmath>

#include "device/types.h"

namespace haptiv {

/// The raster that edges snap to.
struct Grid {
  static constexpr double kStep = 0.01;  ///< [m]

  double snapped(double value) const { return kStep * std::round(value / kStep); }
  Vector3 snapped(const Vector3& value) const { return kStep * (value / kStep).array().round().matrix(); }
};

}  // namespace haptiv
