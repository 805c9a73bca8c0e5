#pragma once

#include <filesystem>
#include <vector>

#include "device/simulated/ScriptedHand.h"

namespace haptiv {

/// Reads a CSV with the header `t,x,y,z`: at time t [s] the hand wants to be at p_WH [m]. The columns `deadman`,
/// `estop` and `reset` may follow: 1 where the operator presses it from then on, 0 where not; without its column the
/// dead-man is pressed all the time and the others never. Throws std::runtime_error "FILE:LINE: what, and what to do"
/// for missing or extra columns, empty cells, numbers that are none, NaN, times that do not rise, and holes (a gap more
/// than ten times the usual step in a sampled file).
std::vector<HandWaypoint> readHandFile(const std::filesystem::path& path);

}  // namespace haptiv
