#pragma once

#include "device/kinematics/Vishard10.h"

namespace haptiv {

/// VISHARD10 with the paper's links.
inline const Vishard10 kArm{LinkLengths{}};

inline constexpr double kRounding = 1e-12;  ///< a few hundred roundings of quantities near one

}  // namespace haptiv
