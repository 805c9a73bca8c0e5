#pragma once

#include <string>

#include "app/bench/wall/WallMap.h"

namespace haptiv {

/// For people: a line a damping, a column a variant and grip.
std::string wallTable(const WallMap& map);
/// grip,variant,damping_N_s_per_m,optimal_stiffness_N_per_m,largest_stable_stiffness_N_per_m; "inf": all were stable
std::string wallLimitsCsv(const WallMap& map);
/// grip,damping_N_s_per_m,stiffness_N_per_m,oscillation_N; "inf": a fault, or contact lost
std::string wallShakingCsv(const WallMap& map);

}  // namespace haptiv
