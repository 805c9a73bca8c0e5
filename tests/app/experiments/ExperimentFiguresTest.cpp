#include "app/experiments/ExperimentFigures.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace haptiv {
namespace {

// A run of every kind, of two samples each.
RunTable everyRun(const DeviceDescription& device) {
  std::vector<RunResult> runs;
  for (const Experiment experiment : {Experiment::circle, Experiment::heights, Experiment::velocities}) {
    for (const Solution solution : {Solution::full, Solution::partitioned}) {
      for (const Strategy strategy : {Strategy::nonopt, Strategy::dir}) {
        for (RunSetup& setup : runsOf(experiment, device, {{strategy, solution}})) {
          RunResult& run = runs.emplace_back();
          run.samples.resize(2);
          run.samples[1].time = setup.duration;
          run.samples[1].indexRot = 3;
          run.setup = std::move(setup);
        }
      }
    }
  }
  return {std::move(runs), {1, 2}};
}

class ExperimentFigures : public testing::Test {
 protected:
  DeviceDescription device_ = loadDeviceDescription("vishard10");
};

TEST_F(ExperimentFigures, AreThePapersTenToEighteen) {
  const auto figures = experimentFigures(everyRun(device_), device_);
  ASSERT_EQ(figures.size(), 9u);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const std::string number = std::to_string(10 + i);
    EXPECT_TRUE(figures[i].name.starts_with("fig" + number)) << figures[i].name;
    EXPECT_TRUE(figures[i].figure.title.starts_with("Fig. " + number)) << figures[i].figure.title;
    for (const FigurePanel& panel : figures[i].figure.panels) {
      EXPECT_FALSE(panel.curves.empty()) << figures[i].name;
      EXPECT_FALSE(panel.x.label.empty() || panel.y.label.empty()) << figures[i].name;
    }
  }
}

TEST_F(ExperimentFigures, DivideTheIndicesByTheirScale) {
  const auto figures = experimentFigures(everyRun(device_), device_);
  EXPECT_DOUBLE_EQ(figures[0].figure.panels[0].curves[0].y[1], 1.5);
}

TEST_F(ExperimentFigures, AreNoneWithoutRuns) {
  EXPECT_TRUE(experimentFigures(RunTable({}, {}), device_).empty());
}

}  // namespace
}  // namespace haptiv
