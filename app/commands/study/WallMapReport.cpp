#include "app/commands/study/WallMapReport.h"

#include <QBuffer>
#include <filesystem>

#include "app/bench/wall/WallFigure.h"
#include "app/bench/wall/WallTables.h"
#include "app/commands/ExitCode.h"
#include "app/commands/WholeFile.h"
#include "app/figures/DrawFigure.h"
#include "app/figures/OffscreenQt.h"
#include "device/control/ControlNames.h"

namespace haptiv {
namespace {

Report::Rows rowsOf(const std::vector<double>& values, std::size_t columns) {
  Report::Rows rows;
  for (auto first = values.begin(); first != values.end(); first += static_cast<std::ptrdiff_t>(columns))
    rows.emplace_back(first, first + static_cast<std::ptrdiff_t>(columns));
  return rows;
}

}  // namespace

Report reportOf(const WallMap& map) {
  Report report;
  report.add("device", map.device);
  report.add("rate_Hz", map.rate);
  report.add("control", nameOf(map.control.display));
  report.add("joints", nameOf(map.control.joints));
  report.add("virtual_mass_kg", map.mass);
  report.add("trials", map.trials);
  report.add("damping_N_s_per_m", map.damping);
  report.add("stiffness_N_per_m", map.stiffness);
  Report::Numbers optimum;
  for (const double damping : map.damping) optimum.push_back(map.optimalStiffness(damping));
  report.add("optimal_stiffness_N_per_m", optimum);
  Report::List limits, shaking;
  for (const WallLimit& limit : map.limits) {
    Report& entry = limits.emplace_back();
    entry.add("grip", limit.grip);
    entry.add("variant", std::string(nameOf(limit.variant)));
    entry.add("largest_stable_stiffness_N_per_m", limit.stiffness);
  }
  for (const WallShaking& each : map.shaking) {
    Report& entry = shaking.emplace_back();
    entry.add("grip", each.grip);
    entry.add("oscillation_N", rowsOf(each.oscillation, map.damping.size()));
  }
  report.add("limits", std::move(limits));
  report.add("shaking", std::move(shaking));
  return report;
}

void writeWallFiles(const WallMap& map, const std::string& folder) {
  std::error_code trouble;
  std::filesystem::create_directories(folder, trouble);
  if (trouble)
    throw CommandFailure(kCouldNot, folder + ": the folder cannot be made: " + trouble.message() + "; choose another");
  const std::filesystem::path path(folder);
  const OffscreenQt qt;
  QBuffer png;
  png.open(QIODevice::WriteOnly);
  drawFigure(wallFigure(map)).save(&png, "PNG");
  writeWholly((path / "wall.png").string(),
              std::string_view(png.data().constData(), static_cast<std::size_t>(png.size())));
  writeWholly((path / "wall-limits.csv").string(), wallLimitsCsv(map));
  writeWholly((path / "wall-shaking.csv").string(), wallShakingCsv(map));
}

}  // namespace haptiv
