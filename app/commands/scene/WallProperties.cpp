#include "app/commands/scene/WallProperties.h"

#include <algorithm>
#include <cstdio>

#include "scenegraph/Keyword.h"
#include "scenegraph/judging/ContactDynamics.h"
#include "scenegraph/judging/PerProperty.h"

namespace haptiv {
namespace {

constexpr std::size_t kMostRows = 20;

struct WallRow {
  int line = 0;
  std::string node;
  std::size_t walls = 0;
  ContactDynamics contact;
  double largest = 0;  ///< stiffness [N/m]
  double depth = 0;    ///< [m]
};

std::vector<WallRow> rowsOf(const LoadedScene& loaded, double rate) {
  const HapticScene& scene = *loaded.compiled.scene;
  const double drives = loaded.device.drives.bandwidth.minCoeff();
  std::vector<WallRow> rows;
  for (const PropertyGroup& group : groupByProperty(loaded.compiled.origins.walls)) {
    const SurfaceProperties& surface = scene.walls[group.members.front()].surface;
    const auto line = loaded.file.lineOf.find(group.property);
    WallRow row;
    row.line = line == loaded.file.lineOf.end() ? 0 : line->second;
    row.node = describe(group.property);
    row.walls = group.members.size();
    row.contact = {scene.tool.mass, surface.stiffness, surface.damping};
    const double sampled = row.contact.largestSampledStiffness(1 / rate);
    row.largest = std::max(0.0, std::min(sampled, scene.tool.mass * drives * drives));
    row.depth = loaded.device.hand.peakForce / surface.stiffness;
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

Report::List wallProperties(const LoadedScene& loaded, double rate) {
  Report::List list;
  for (const WallRow& row : rowsOf(loaded, rate)) {
    Report& entry = list.emplace_back();
    entry.add("line", std::uint64_t(row.line));
    entry.add("node", row.node);
    entry.add("walls", std::uint64_t{row.walls});
    entry.add("stiffness_N_per_m", row.contact.stiffness);
    entry.add("damping_N_s_per_m", row.contact.damping);
    entry.add("natural_frequency_rad_per_s", row.contact.naturalFrequency());
    entry.add("damping_ratio", row.contact.dampingRatio());
    entry.add("optimal_stiffness_N_per_m", row.contact.optimalStiffness());
    entry.add("largest_stable_stiffness_N_per_m", row.largest);
    entry.add("depth_at_peak_force_m", row.depth);
  }
  return list;
}

std::string wallTable(const LoadedScene& loaded, double rate) {
  const std::vector<WallRow> rows = rowsOf(loaded, rate);
  if (rows.empty()) return {};
  std::string text =
      "\n     walls   stiffness     damping  damping      optimal     largest       depth\n"
      "                 N/m       N s/m    ratio  stiffn. N/m  stable N/m  at peak, m  of\n";
  for (std::size_t i = 0; i < std::min(rows.size(), kMostRows); ++i) {
    const WallRow& row = rows[i];
    char line[160];
    std::snprintf(line, sizeof line, "%10zu %11.5g %11.4g %8.3g %12.4g %11.4g %11.3g  ", row.walls,
                  row.contact.stiffness, row.contact.damping, row.contact.dampingRatio(),
                  row.contact.optimalStiffness(), row.largest, row.depth);
    text += line + row.node + (row.line > 0 ? ", line " + std::to_string(row.line) : "") + "\n";
  }
  if (rows.size() > kMostRows) text += "  and " + std::to_string(rows.size() - kMostRows) + " more; --json lists all\n";
  return text;
}

}  // namespace haptiv
