#include "app/experiments/ExperimentFigures.h"

#include <algorithm>
#include <numbers>

#include "app/experiments/TrajectoryFigure.h"
#include "device/control/ResolutionNames.h"

namespace haptiv {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kShownRadius = 0.8;  // of figures 10 and 11 [m]

const char* legendName(Strategy strategy) {
  constexpr const char* kNames[] = {"nonopt.", "man.", "dir. man.", "cond."};
  return kNames[static_cast<std::size_t>(strategy)];
}

/// Panels for the rotational and the translational index over x; no curves yet.
Figure indexFigure(const std::string& title, const FigureAxis& x) {
  Figure figure;
  figure.title = title;
  figure.columns = 2;
  figure.panels.resize(2);
  figure.panels[0].y.label = "rot. man. index, normalised";
  figure.panels[1].y.label = "trans. man. index, normalised";
  for (FigurePanel& panel : figure.panels) panel.x = x;
  return figure;
}

/// A run's indices, over time or over the angle along the path.
void addRun(Figure& figure, const RunResult& run, const IndexScale& scale, int style, bool overAngle) {
  FigureCurve rot, trans;
  for (const RunSample& sample : run.samples) {
    rot.x.push_back(overAngle ? run.setup.path.angle(sample.time) : sample.time);
    rot.y.push_back(sample.indexRot / scale.rot);
    trans.y.push_back(sample.indexTrans / scale.trans);
  }
  trans.x = rot.x;
  rot.style = trans.style = style;
  figure.panels[0].curves.push_back(std::move(rot));
  figure.panels[1].curves.push_back(std::move(trans));
}

FigureAxis angleAxis() {
  return {"φ [rad]", std::pair(0., 4 * kPi), {{0, "0"}, {kPi, "π"}, {2 * kPi, "2π"}, {3 * kPi, "3π"}, {4 * kPi, "4π"}}};
}

/// Figures 10 and 11.
Figure overTime(const RunTable& table, Solution solution) {
  Figure figure =
      indexFigure("Manipulability indices, " + nameOf(solution) + " solution, r = 0.8 m", {"t [s]", {}, {}});
  for (const Strategy strategy : kStrategies) {
    const RunResult* run = table.find(Experiment::circle, {strategy, solution}, kShownRadius);
    if (!run) continue;
    const int style = static_cast<int>(strategy);
    addRun(figure, *run, table.scale(), style, false);
    figure.legend.push_back({legendName(strategy), style});
  }
  return figure;
}

/// Figures 12 and 13.
Figure overRadius(const RunTable& table, Solution solution) {
  Figure figure =
      indexFigure("Mean manipulability indices, " + nameOf(solution) + " solution", {"r [m]", std::pair(0., 0.85), {}});
  figure.panels[0].y.label = "mean rot. man. index, normalised";
  figure.panels[1].y.label = "mean trans. man. index, normalised";
  for (const Strategy strategy : kStrategies) {
    FigureCurve rot, trans;
    for (const double radius : kRadii) {
      const RunResult* run = table.find(Experiment::circle, {strategy, solution}, radius);
      if (!run) continue;
      rot.x.push_back(radius);
      rot.y.push_back(run->summary.meanIndexRot / table.scale().rot);
      trans.y.push_back(run->summary.meanIndexTrans / table.scale().trans);
    }
    if (rot.x.empty()) continue;
    trans.x = rot.x;
    rot.style = trans.style = static_cast<int>(strategy);
    rot.markers = trans.markers = true;
    figure.legend.push_back({legendName(strategy), rot.style, true, true});
    figure.panels[0].curves.push_back(std::move(rot));
    figure.panels[1].curves.push_back(std::move(trans));
  }
  return figure;
}

/// The criterion that stands for the optimised solutions in figures 15 to 18: `dir`, or what was run instead.
const RunResult* optimised(const RunTable& table, Experiment experiment, Solution solution, double varied) {
  for (const Strategy strategy : {Strategy::dir, Strategy::cond, Strategy::man}) {
    if (const RunResult* run = table.find(experiment, {strategy, solution}, varied)) return run;
  }
  return nullptr;
}

/// Figures 15 and 16.
Figure overHeights(const RunTable& table, Solution solution) {
  Figure figure = indexFigure("", angleAxis());
  int style = 0;
  for (const double height : kHeights) {
    const RunResult* run = optimised(table, Experiment::heights, solution, height);
    if (!run) continue;
    figure.title = "Optimised " + nameOf(solution) + " solution (" + legendName(run->setup.choice.strategy) +
                   ") at three heights, v = 1 m/s";
    constexpr const char* kKeys[] = {"z = -0.30 m", "z = -0.15 m", "z = 0.00 m"};
    figure.legend.push_back({kKeys[style], style});
    addRun(figure, *run, table.scale(), style++, true);
  }
  return figure;
}

/// Figures 17 and 18.
Figure overVelocities(const RunTable& table, Solution solution) {
  Figure figure =
      indexFigure("Manipulability at two velocities, " + nameOf(solution) + " solution, z = 0.3 m", angleAxis());
  const auto add = [&](const RunResult* run, const std::string& key, int style) {
    if (!run) return;
    figure.legend.push_back({key, style});
    addRun(figure, *run, table.scale(), style, true);
  };
  add(table.find(Experiment::velocities, {Strategy::nonopt, solution}, 1), "nonopt., any v", 0);
  for (const double speed : kSpeeds) {
    const RunResult* run = optimised(table, Experiment::velocities, solution, speed);
    if (run)
      add(run, legendName(run->setup.choice.strategy) + std::string(speed < 1 ? ", v = 0.1 m/s" : ", v = 1 m/s"),
          speed < 1 ? 1 : 2);
  }
  return figure;
}

bool isEmpty(const Figure& figure) {
  return std::ranges::all_of(figure.panels, [](const FigurePanel& panel) { return panel.curves.empty(); });
}

}  // namespace

std::vector<NamedFigure> experimentFigures(const RunTable& table, const DeviceDescription& device) {
  std::vector<NamedFigure> figures = {
      {"fig10-circle-full-r0.80", overTime(table, Solution::full)},
      {"fig11-circle-partitioned-r0.80", overTime(table, Solution::partitioned)},
      {"fig12-circle-full-means", overRadius(table, Solution::full)},
      {"fig13-circle-partitioned-means", overRadius(table, Solution::partitioned)},
      {"fig15-heights-full", overHeights(table, Solution::full)},
      {"fig16-heights-partitioned", overHeights(table, Solution::partitioned)},
      {"fig17-velocities-full", overVelocities(table, Solution::full)},
      {"fig18-velocities-partitioned", overVelocities(table, Solution::partitioned)},
  };
  std::erase_if(figures, [](const NamedFigure& named) { return isEmpty(named.figure); });
  const bool second = std::ranges::any_of(
      table.runs(), [](const RunResult& run) { return run.setup.experiment != Experiment::circle; });
  if (second) figures.push_back({"fig14-trajectory", trajectoryFigure(device)});
  std::ranges::sort(figures, {}, &NamedFigure::name);
  for (NamedFigure& named : figures) named.figure.title = "Fig. " + named.name.substr(3, 2) + "  " + named.figure.title;
  return figures;
}

}  // namespace haptiv
