#include "app/bench/wall/WallTables.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace haptiv {
namespace {

template <typename... Arguments>
std::string printed(const char* format, Arguments... arguments) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), format, arguments...);
  return text.data();
}

std::string cell(const WallMap& map, double limit) {
  if (limit == 0) return printed("< %.3g", map.stiffness.front());
  if (std::isinf(limit)) return printed("> %.3g", map.stiffness.back());
  return printed("%.3g", limit);
}

}  // namespace

std::string wallTable(const WallMap& map) {
  std::string table = printed("\nLargest stable stiffness [N/m], %s at %.0f Hz, virtual mass %.3g kg\n%8s %10s",
                              map.device.c_str(), map.rate, map.mass, "b", "b^2/2m");
  for (const WallLimit& limit : map.limits) table += printed(" %10s", nameOf(limit.variant));
  table += printed("\n%8s %10s", "N s/m", "N/m");
  for (const WallLimit& limit : map.limits) table += printed(" %10s", limit.grip.c_str());
  table += "\n";
  for (std::size_t i = 0; i < map.damping.size(); ++i) {
    table += printed("%8.3g %10.3g", map.damping[i], map.optimalStiffness(map.damping[i]));
    for (const WallLimit& limit : map.limits) table += printed(" %10s", cell(map, limit.stiffness[i]).c_str());
    table += "\n";
  }
  return table;
}

std::string wallLimitsCsv(const WallMap& map) {
  std::string table = "grip,variant,damping_N_s_per_m,optimal_stiffness_N_per_m,largest_stable_stiffness_N_per_m\n";
  for (const WallLimit& limit : map.limits) {
    for (std::size_t i = 0; i < map.damping.size(); ++i) {
      table += printed("%s,%s,%.6g,%.6g,%.6g\n", limit.grip.c_str(), nameOf(limit.variant), map.damping[i],
                       map.optimalStiffness(map.damping[i]), limit.stiffness[i]);
    }
  }
  return table;
}

std::string wallShakingCsv(const WallMap& map) {
  std::string table = "grip,damping_N_s_per_m,stiffness_N_per_m,oscillation_N\n";
  for (const WallShaking& shaking : map.shaking) {
    for (std::size_t i = 0; i < shaking.oscillation.size(); ++i) {
      table += printed("%s,%.6g,%.6g,%.6g\n", shaking.grip.c_str(), map.damping[i % map.damping.size()],
                       map.stiffness[i / map.damping.size()], shaking.oscillation[i]);
    }
  }
  return table;
}

}  // namespace haptiv
