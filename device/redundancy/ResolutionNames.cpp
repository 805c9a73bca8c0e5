#include "device/redundancy/ResolutionNames.h"

namespace haptiv {
namespace {

template <typename Options>
auto named(const Options& options, std::string_view name) -> std::optional<typename Options::value_type> {
  for (const auto option : options)
    if (nameOf(option) == name) return option;
  return std::nullopt;
}

}  // namespace

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
  return named(kStrategies, name);
}

std::optional<Solution> solutionNamed(std::string_view name) {
  return named(kSolutions, name);
}

}  // namespace haptiv
