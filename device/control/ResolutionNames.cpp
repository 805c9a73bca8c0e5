#include "device/control/ResolutionNames.h"

#include "device/NamedOption.h"

namespace haptiv {

std::string nameOf(Strategy strategy) {
  switch (strategy) {
    case Strategy::nonopt:
      return "nonopt";
    case Strategy::man:
      return "man";
    case Strategy::dir:
      return "dir";
    case Strategy::cond:
      return "cond";
  }
  return "unknown";
}

std::string nameOf(Solution solution) {
  return solution == Solution::full ? "full" : "partitioned";
}

std::optional<Strategy> strategyNamed(std::string_view name) {
  return optionNamed(kStrategies, name);
}

std::optional<Solution> solutionNamed(std::string_view name) {
  return optionNamed(kSolutions, name);
}

}  // namespace haptiv
