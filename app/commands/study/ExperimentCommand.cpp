#include "app/commands/study/ExperimentCommand.h"

#include <QBuffer>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/commands/ExitCode.h"
#include "app/commands/Progress.h"
#include "app/commands/WholeFile.h"
#include "app/experiments/ExperimentFigures.h"
#include "app/experiments/RunCsv.h"
#include "app/experiments/Simulation.h"
#include "app/experiments/claims/Claims.h"
#include "app/experiments/claims/ClaimsText.h"
#include "app/figures/DrawFigure.h"
#include "app/figures/OffscreenQt.h"
#include "device/control/ResolutionNames.h"

namespace haptiv {
namespace {

constexpr Experiment kExperiments[] = {Experiment::circle, Experiment::heights, Experiment::velocities};

struct ExperimentOptions {
  std::string which;
  std::vector<std::string> strategies = {"nonopt", "man", "dir", "cond"};
  std::vector<std::string> solutions = {"full", "partitioned"};
  std::string out;
  bool json = false;
};

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

/// Whatever their order on the command line, the runs have one order.
std::vector<ResolutionChoice> choicesOf(const ExperimentOptions& options) {
  std::vector<ResolutionChoice> choices;
  for (const Solution solution : kSolutions) {
    for (const Strategy strategy : kStrategies) {
      if (has(options.solutions, nameOf(solution)) && has(options.strategies, nameOf(strategy)))
        choices.push_back({strategy, solution});
    }
  }
  return choices;
}

void makeFolder(const std::string& path) {
  std::error_code trouble;
  std::filesystem::create_directories(path, trouble);
  if (trouble)
    throw CommandFailure(kCouldNot, path + ": the folder cannot be made: " + trouble.message() + "; choose another");
}

void write(const ExperimentOptions& options, const std::string& name, std::string_view bytes) {
  writeWholly((std::filesystem::path(options.out) / name).string(), bytes);
}

std::vector<RunResult> runAll(const ExperimentOptions& options, const DeviceDescription& device) {
  const std::vector<ResolutionChoice> choices = choicesOf(options);
  std::vector<RunSetup> setups;
  for (const Experiment experiment : kExperiments) {
    if (options.which == "all" || options.which == nameOf(experiment))
      std::ranges::move(runsOf(experiment, device, choices), std::back_inserter(setups));
  }
  const RedundancyResolution first(deviceFor(Experiment::circle, device));
  const RedundancyResolution second(deviceFor(Experiment::heights, device));
  std::vector<RunResult> results;
  Progress progress(setups.size());
  for (const RunSetup& setup : setups) {
    progress.step(setup.name());
    results.push_back(simulate(setup, device, setup.experiment == Experiment::circle ? first : second));
    write(options, setup.name() + ".csv", toCsv(results.back()));
  }
  return results;
}

void writeFigures(const ExperimentOptions& options, const RunTable& table, const DeviceDescription& device) {
  const OffscreenQt qt;
  for (const auto& [name, figure] : experimentFigures(table, device)) {
    QBuffer png;
    png.open(QIODevice::WriteOnly);
    drawFigure(figure).save(&png, "PNG");
    write(options, name + ".png", std::string_view(png.data().constData(), static_cast<std::size_t>(png.size())));
  }
}

/// What `dir`, the criterion that the index is, is divided by in the full solution: one scale for all runs.
IndexScale scaleOf(const DeviceDescription& device) {
  const CriterionPair best =
      RedundancyResolution(deviceFor(Experiment::circle, device)).normalisationOf({Strategy::dir, Solution::full});
  return {best.translation, best.rotation};
}

int runExperiments(const ExperimentOptions& options) {
  const DeviceDescription device = loadDeviceDescription("vishard10");
  makeFolder(options.out);
  const RunTable table(runAll(options, device), scaleOf(device));
  writeFigures(options, table, device);
  const std::vector<Claim> claims = judgeClaims(table);
  write(options, "claims.md", claimsToMarkdown(claims));
  write(options, "claims.json", claimsToJson(claims));
  std::cout << (options.json ? claimsToJson(claims) : claimsToText(claims)) << std::flush;
  if (!std::cout)
    throw CommandFailure(kCouldNot, "standard output cannot be written; the claims are in " + options.out);
  return kGood;
}

}  // namespace

void addExperimentCommand(const Command& program) {
  const auto options = std::make_shared<ExperimentOptions>();
  const Command experiment =
      program.add("experiment", "The paper's numerical experiments: a CSV each, its figures, a verdict on its claims",
                  [options] { return runExperiments(*options); });
  experiment
      .choice("WHICH", options->which, {"circle", "heights", "velocities", "all"},
              "circle: radii 0.05 to 0.8 m; heights: z = -0.3 to 0 m; velocities: 0.1 and 1 m/s; all: a verdict on "
              "each claim")
      .required();
  experiment
      .choices("--strategy", options->strategies, {"nonopt", "man", "dir", "cond"}, "How the redundancy is resolved")
      .type("NAME,...")
      .showDefault();
  experiment.choices("--solution", options->solutions, {"full", "partitioned"}, "All joints at once, or by parts")
      .type("NAME,...")
      .showDefault();
  experiment.path("--out", options->out, "Folder for the files; made where it is missing").type("DIR").required();
  experiment.json(options->json);
}

}  // namespace haptiv
