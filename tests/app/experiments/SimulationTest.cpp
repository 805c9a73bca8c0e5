#include "app/experiments/Simulation.h"

#include <gtest/gtest.h>

#include <sstream>

#include "app/experiments/RunCsv.h"
#include "device/kinematics/Vishard10.h"

namespace haptiv {
namespace {

RunResult shortRun(double seconds, const ResolutionChoice& choice = {Strategy::dir, Solution::full}) {
  const DeviceDescription device = loadDeviceDescription("vishard10");
  RunSetup setup = circleRun(device, choice, 0.6);
  setup.duration = seconds;
  return simulate(setup, device, RedundancyResolution(deviceFor(setup.experiment, device)));
}

TEST(Simulation, FollowsThePathAndKeepsTheOrientation) {
  const RunResult result = shortRun(0.2);
  const Vishard10 arm(loadDeviceDescription("vishard10").links);
  for (const RunSample& sample : result.samples) {
    const Pose wanted = result.setup.path.at(sample.time), is = arm.forward(sample.q);
    EXPECT_LT((is.position - wanted.position).norm(), 1e-4) << "0.1 mm is what is asked of 1 m/s at 1 kHz";
    EXPECT_LT((is.rotation - wanted.rotation).norm(), 1e-4);
    EXPECT_NEAR(sample.positionError, (is.position - wanted.position).norm(), 1e-12);
  }
}

TEST(Simulation, SamplesEveryFiveTicksAndTheLast) {
  const RunResult result = shortRun(0.052);
  ASSERT_EQ(result.samples.size(), 12u);
  EXPECT_DOUBLE_EQ(result.samples[1].time, 0.005);
  EXPECT_DOUBLE_EQ(result.samples.back().time, 0.052);
}

TEST(Simulation, SummarisesWhatTheSamplesShow) {
  const RunResult result = shortRun(0.1);
  double mean = 0;
  for (const RunSample& sample : result.samples) {
    EXPECT_GE(sample.sigmaRot[2], result.summary.leastSigmaRot);
    EXPECT_LE(sample.positionError, result.summary.greatestPositionError);
    EXPECT_LE(sample.rates.cwiseAbs().maxCoeff(), result.summary.greatestRate);
    mean += sample.indexTrans / static_cast<double>(result.samples.size());
  }
  EXPECT_NEAR(result.summary.meanIndexTrans / mean, 1, 0.01) << "every fifth tick of a smooth run";
  EXPECT_TRUE(result.summary.finite);
}

TEST(Simulation, SelfMotionLeavesTheToolWhereItIs) {
  const RunSummary summary = shortRun(0.1).summary;
  EXPECT_LT(kTick * summary.selfMotionVelocity, 1e-9);
  EXPECT_LT(summary.rateBeyondBounds, 1e-9);
}

TEST(RunCsv, HasTheColumnsThatScriptsRelyOn) {
  std::istringstream table(toCsv(shortRun(0.01)));
  std::string header, row;
  std::getline(table, header);
  EXPECT_TRUE(header.starts_with("t_s,q1,q2,q3,q4,q5,q6,q7,q8,q9,q10,index_trans,index_rot,sigma_min_rot,")) << header;
  const auto commas = std::ranges::count(header, ',');
  int rows = 0;
  for (; std::getline(table, row); ++rows) EXPECT_EQ(std::ranges::count(row, ','), commas) << row;
  EXPECT_EQ(rows, 3);
}

TEST(RunCsv, IsTheSameToTheByteTwice) {
  EXPECT_EQ(toCsv(shortRun(0.1)), toCsv(shortRun(0.1)));
}

}  // namespace
}  // namespace haptiv
