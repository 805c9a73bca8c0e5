#include "app/commands/device/DeviceCheckCommand.h"

#include <array>
#include <cstdio>
#include <iostream>
#include <memory>

#include "app/commands/ExitCode.h"
#include "app/commands/NamedFile.h"
#include "app/commands/Picture.h"
#include "app/commands/Progress.h"
#include "app/commands/Report.h"
#include "app/devicecheck/ManipulabilityMap.h"
#include "app/devicecheck/SpecificationTable.h"
#include "app/figures/DrawFigure.h"
#include "app/figures/OffscreenQt.h"
#include "device/control/ResolutionNames.h"

namespace haptiv {
namespace {

struct DeviceCheckOptions {
  std::string description = "vishard10";
  std::string strategy;  // empty: the description's
  std::string solution;  // empty: the description's
  std::string map;       // PNG; empty: none
  bool json = false;
};

ResolutionChoice choiceOf(const DeviceCheckOptions& options, const DeviceDescription& device) {
  ResolutionChoice choice = device.redundancy.choice;
  if (!options.strategy.empty()) choice.strategy = *strategyNamed(options.strategy);
  if (!options.solution.empty()) choice.solution = *solutionNamed(options.solution);
  return choice;
}

Report::Numbers anglesOf(const SpecificationRow& row, const DeviceDescription& device) {
  return {row.where.q.data(), row.where.q.data() + device.jointCount()};
}

std::string text(double number) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.4g", number);
  return buffer.data();
}

std::string text(const Report::Numbers& list) {
  std::string all;
  for (const double number : list) all += (all.empty() ? "" : " ") + text(number);
  return all;
}

std::string column(const std::string& entry, std::size_t width) {
  return entry + std::string(entry.size() < width ? width - entry.size() : 1, ' ');
}

/// One line a row: limit, worst value, verdict, and the pose of the worst value.
void printTable(const std::vector<SpecificationRow>& rows, const DeviceDescription& device) {
  std::cout << "  " << column("property", 22) << column("limit", 12) << column("worst", 12) << column("holds", 7)
            << column("at x y z [m]", 26) << "joint angles [rad]\n";
  for (const SpecificationRow& row : rows) {
    std::cout << "  " << column(row.property, 22) << column((row.atLeast ? ">= " : "<= ") + text(row.limit), 12)
              << column(text(row.worst), 12) << column(row.holds() ? "yes" : "NO", 7)
              << column(text(numbers(row.where.position)), 26) << text(anglesOf(row, device)) << "\n";
  }
}

Report::List listOf(const std::vector<SpecificationRow>& rows, const DeviceDescription& device) {
  Report::List list;
  for (const SpecificationRow& row : rows) {
    Report& entry = list.emplace_back();
    entry.add("property", row.property);
    entry.add(row.atLeast ? "at_least" : "at_most", row.limit);
    entry.add("worst", row.worst);
    entry.add("holds", row.holds());
    entry.add("position_m", numbers(row.where.position));
    entry.add("joint_angles_rad", anglesOf(row, device));
    if (!row.remark.empty()) entry.add("remark", row.remark);
  }
  return list;
}

/// Empty where everything holds.
std::string whatDoesNotHold(const std::vector<SpecificationRow>& rows, const Tour& tour) {
  std::string all;
  for (const SpecificationRow& row : rows) {
    if (row.holds()) continue;
    all += "\n  " + row.property + " is " + text(row.worst) + " at (" + text(numbers(row.where.position)) + ") m" +
           (row.remark.empty() ? "" : ": " + row.remark);
  }
  if (tour.placesMissed > 0) all += "\n  " + std::to_string(tour.placesMissed) + " places were not reached";
  return all;
}

void saveMap(const DeviceCheckOptions& options, const Tour& tour, const TourGrid& grid,
             const Specification& specification, const std::string& title) {
  const OffscreenQt qt;
  savePicture(drawFigure(manipulabilityMap(tour, grid, specification, title)), options.map);
}

int checkDevice(const DeviceCheckOptions& options) {
  const DeviceDescription device = loadDeviceDescription(options.description);
  if (device.delta)
    throw CommandFailure(kWrongUsage, options.description +
                                          ": is a parallel arm, and this check is for serial ones of VISHARD10's size; "
                                          "give another description");
  const ResolutionChoice choice = choiceOf(options, device);
  if (!options.map.empty()) requireWritable(options.map);
  const Specification specification;
  const TourGrid grid;
  Progress progress(static_cast<std::size_t>(tourParts(grid)));
  const Tour tour = tourWorkspace(device, choice, specification, grid, [&] { progress.step("of the workspace"); });
  progress.finish();
  const std::vector<SpecificationRow> rows = judge(tour, specification, device);
  const std::string wrong = whatDoesNotHold(rows, tour);

  Report report;
  report.add("description", device.name);
  report.add("strategy", nameOf(choice.strategy));
  report.add("solution", nameOf(choice.solution));
  report.add("holds", wrong.empty());
  report.add("places", static_cast<std::uint64_t>(tour.places));
  report.add("places_missed", static_cast<std::uint64_t>(tour.placesMissed));
  report.add("poses", std::uint64_t{tour.samples.size()});
  if (options.json) report.add("rows", listOf(rows, device));
  if (!options.map.empty()) {
    saveMap(options, tour, grid, specification,
            device.name + ", " + nameOf(choice.strategy) + ", " + nameOf(choice.solution));
    report.add("map", options.map);
  }
  if (!options.json) printTable(rows, device);
  report.print(options.json);
  if (!wrong.empty()) throw CommandFailure(kNotSo, device.name + " does not meet the specification:" + wrong);
  return kGood;
}

}  // namespace

void addDeviceCheckCommand(const Command& device) {
  const auto options = std::make_shared<DeviceCheckOptions>();
  const Command check = device.add("check", "Hold an arm against the specification of VISHARD10, by moving it about",
                                   [options] { return checkDevice(*options); });
  check.path("DESCRIPTION", options->description, "A built-in name, or a device description (.toml)").showDefault();
  check
      .choice("--strategy", options->strategy, {"nonopt", "man", "dir", "cond"},
              "How the redundancy is resolved; the description's")
      .type("NAME");
  check.choice("--solution", options->solution, {"full", "partitioned"}, "All joints at once, or by parts")
      .type("NAME");
  check.path("--map", options->map, "Draw the manipulability over the workspace, 1280 x 720; needs no display")
      .type("FILE.png");
  check.json(options->json);
}

}  // namespace haptiv
