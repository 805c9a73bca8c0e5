#include "app/commands/study/BenchCommand.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>
#include <memory>

#include "app/bench/Benches.h"
#include "app/bench/wall/WallTables.h"
#include "app/commands/ExitCode.h"
#include "app/commands/Report.h"
#include "app/commands/study/WallMapReport.h"
#include "app/session/choices/SceneControl.h"
#include "app/timing/DurationText.h"
#include "device/control/ControlNames.h"
#include "haptics/servo/ServoPace.h"
#include "scenegraph/reading/SceneFile.h"

namespace haptiv {
namespace {

constexpr Range kWallRates{kLowestServoRate, kHighestServoRate};

struct BenchOptions {
  std::vector<std::string> names;
  std::string device = "vishard10";
  double rate = 1000;           // [Hz]
  std::string control, joints;  // empty: as the description says
  std::string out;              // empty: no files
  bool json = false;
};

std::string allNames() {
  std::string names;
  for (const Bench& bench : kBenches) names += (names.empty() ? "" : ", ") + std::string(bench.name);
  return names;
}

void requireKnown(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const bool known = std::ranges::any_of(kBenches, [&](const Bench& bench) { return name == bench.name; });
    if (!known) throw CommandFailure(kWrongUsage, "there is no bench \"" + name + "\"; there are " + allNames());
  }
}

std::string notesOf(const BenchResult& result) {
  std::string notes;
  for (const auto& [name, value] : result.notes) {
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "%s%s %.6g", notes.empty() ? "" : ", ", name.c_str(), value);
    notes += text.data();
  }
  std::ranges::replace(notes, '_', ' ');
  return notes;
}

void printTable(const BenchRun& run) {
  std::printf("%-26s %8s %10s %10s %12s  %s\n", "", "n", "median", "p99", "peer median", "");
  for (const BenchResult& result : run.results()) {
    const std::string peer = result.peerMedianNs ? durationText(*result.peerMedianNs) : "-";
    std::printf("%-26s %8llu %10s %10s %12s  %s%s%s\n", result.name.c_str(), static_cast<unsigned long long>(result.n),
                durationText(result.medianNs).c_str(), durationText(result.p99Ns).c_str(), peer.c_str(),
                result.peer.c_str(), result.peer.empty() || result.notes.empty() ? "" : "; ", notesOf(result).c_str());
  }
  if (run.wallMap()) std::fputs(wallTable(*run.wallMap()).c_str(), stdout);
  std::fflush(stdout);
}

void printJson(const BenchRun& run) {
  Report::List list;
  for (const BenchResult& result : run.results()) {
    Report& entry = list.emplace_back();
    entry.add("name", result.name);
    entry.add("n", result.n);
    entry.add("median_ns", result.medianNs);
    entry.add("p99_ns", result.p99Ns);
    entry.add("peer_median_ns", result.peerMedianNs ? Report::Value(*result.peerMedianNs) : nullptr);
    entry.add("peer", result.peer.empty() ? Report::Value(nullptr) : result.peer);
    for (const auto& [name, value] : result.notes) entry.add(name, value);
  }
  Report report;
  report.add("results", std::move(list));
  if (run.wallMap()) report.addPart("wall_map", reportOf(*run.wallMap()));
  report.print(true);
}

/// The arm, driven as is chosen. Throws what expectControllable throws.
DeviceDescription deviceOf(const BenchOptions& options) {
  DeviceDescription device = loadDeviceDescription(options.device);
  ControlChoice& choice = device.control.choice;
  choice.display = displayModeNamed(options.control).value_or(choice.display);
  choice.joints = jointControllerNamed(options.joints).value_or(choice.joints);
  expectControllable(choice, device);
  return device;
}

int runBenches(const BenchOptions& options) {
  requireKnown(options.names);
  initSceneGraph();
  BenchRun run({deviceOf(options), options.rate, {}});
  for (const Bench& bench : kBenches) {
    if (options.names.empty() || std::ranges::find(options.names, bench.name) != options.names.end()) bench.run(run);
  }
  if (options.json) {
    printJson(run);
  } else {
    printTable(run);
  }
  if (run.wallMap() && !options.out.empty()) writeWallFiles(*run.wallMap(), options.out);
  return kGood;
}

}  // namespace

void addBenchCommand(const Command& program) {
  const auto options = std::make_shared<BenchOptions>();
  const Command bench = program.add("bench", "Measure the program itself", [options] { return runBenches(*options); });
  bench.list("BENCH", options->names, ("Which ones, with commas between: " + allNames() + "; none: all").c_str());
  bench.text("--device", options->device, "Of wall: the arm, a built-in description or a file")
      .type("DESCRIPTION")
      .showDefault();
  bench.number("--rate", options->rate, kWallRates, "Of wall: ticks per second, 500 to 8000").type("HZ").showDefault();
  bench.choice("--control", options->control, {"admittance", "position-impedance", "impedance"},
               "Of wall: what the device shows; without this, as the device description says");
  bench.choice("--joints", options->joints, {"pd", "computed-torque"},
               "Of wall: how the joints follow; without this, as the device description says");
  bench.path("--out", options->out, "Of wall: a folder for the map as PNG and CSV; made where it is missing")
      .type("DIR");
  bench.json(options->json);
}

}  // namespace haptiv
