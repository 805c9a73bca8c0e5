#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "device/control/ResolutionChoice.h"

namespace haptiv {

inline constexpr std::array kStrategies = {Strategy::nonopt, Strategy::man, Strategy::dir, Strategy::cond};
inline constexpr std::array kSolutions = {Solution::full, Solution::partitioned};

/// The names by which users choose: "nonopt", "man", "dir", "cond"; "full", "partitioned".
std::string nameOf(Strategy strategy);
std::string nameOf(Solution solution);
/// Nothing where there is none of this name.
std::optional<Strategy> strategyNamed(std::string_view name);
std::optional<Solution> solutionNamed(std::string_view name);

}  // namespace haptiv
