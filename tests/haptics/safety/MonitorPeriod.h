#pragma once

namespace haptiv::testing {

inline constexpr double kMonitorPeriod = 1e-3;  ///< [s]

}  // namespace haptiv::testing
