#include "app/experiments/RunSetup.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

#include "device/control/ResolutionNames.h"
#include "device/kinematics/Vishard10.h"

namespace haptiv {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-12;  // [m], [rad]

class RunSetups : public testing::Test {
 protected:
  Pose start(const RunSetup& run) const { return arm_.forward(run.startAngles); }
  // The elbow in the middle of the four links.
  Vector3 joint3(const RunSetup& run) const { return arm_.skeleton(run.startAngles).at[2]; }

  DeviceDescription device_ = loadDeviceDescription("vishard10");
  Vishard10 arm_{device_.links};
};

TEST_F(RunSetups, CirclesStartAtTheRadiusAtThePapersHeight) {
  for (const double radius : kRadii) {
    const RunSetup run = circleRun(device_, {}, radius);
    const Vector3 expected(radius, 0, -2 * 0.212 * std::cos(kPi / 6));  // the paper rounds it to -0.36 m
    EXPECT_LT((start(run).position - expected).norm(), kRounding) << radius;
    EXPECT_GT(joint3(run).y(), 0) << radius;
    EXPECT_EQ(run.startAngles[1], -kPi / 4);
    EXPECT_EQ(run.startAngles[3], -kPi / 4);
    EXPECT_NEAR(run.startAngles.head<5>().sum(), kPi / 2, kRounding);
  }
}

TEST_F(RunSetups, TheSecondExperimentStartsAt80CentimetresAtItsHeight) {
  std::vector<RunSetup> runs;
  for (const double height : kHeights) runs.push_back(heightRun(device_, {}, height));
  for (const double speed : kSpeeds) runs.push_back(velocityRun(device_, {}, speed));
  const double heights[] = {-0.3, -0.15, 0, 0.3, 0.3};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_LT((start(runs[i]).position - Vector3(0.8, 0, heights[i])).norm(), kRounding) << runs[i].name();
    EXPECT_GT(joint3(runs[i]).y(), 0);
    EXPECT_NEAR(runs[i].startAngles[4], kPi / 2 + runs[i].startAngles[0], kRounding);
    EXPECT_EQ(runs[i].startAngles[7], runs[i].startAngles[5]);
  }
}

TEST_F(RunSetups, EveryPathStartsWhereTheArmIsAndGoesClockwise) {
  for (const Experiment experiment : {Experiment::circle, Experiment::heights, Experiment::velocities}) {
    for (const RunSetup& run : runsOf(experiment, device_, {ResolutionChoice{}})) {
      EXPECT_LT((run.path.at(0).position - start(run).position).norm(), kRounding) << run.name();
      EXPECT_LT((run.path.at(0).rotation - start(run).rotation).norm(), kRounding) << run.name();
      const Vector3 before = run.path.at(0.1).position - run.path.centre;
      const Vector3 after = run.path.at(0.2).position - run.path.centre;
      EXPECT_LT(before.cross(after).z(), 0) << run.name();
      const double distance = (run.path.at(1e-4).position - run.path.at(0).position).norm();
      EXPECT_NEAR(distance / 1e-4, run.path.speed, 1e-5) << run.name();
    }
  }
}

TEST_F(RunSetups, RunsAreAsLongAsThePaperSays) {
  EXPECT_DOUBLE_EQ(circleRun(device_, {}, 0.8).duration, 2 * kPi * 0.8);
  EXPECT_DOUBLE_EQ(circleRun(device_, {}, 0.05).duration, 1) << "longer than its turn of 0.31 s";
  EXPECT_DOUBLE_EQ(heightRun(device_, {}, 0).duration, 4 * kPi * 0.4);
  EXPECT_DOUBLE_EQ(velocityRun(device_, {}, 0.1).duration, 4 * kPi * 4);
}

TEST_F(RunSetups, AreNamedForWhatTheyVary) {
  EXPECT_EQ(circleRun(device_, {}, 0.4).name(), "circle-full-nonopt-r0.40");
  EXPECT_EQ(heightRun(device_, {Strategy::dir, Solution::partitioned}, -0.15).name(), "heights-partitioned-dir-z-0.15");
  EXPECT_EQ(heightRun(device_, {}, 0).name(), "heights-full-nonopt-z0.00");
  EXPECT_EQ(velocityRun(device_, {Strategy::cond, Solution::full}, 0.1).name(), "velocities-full-cond-v0.10");
}

TEST_F(RunSetups, TheSecondExperimentHasThePapersStepsAndWeights) {
  const RedundancySettings circle = deviceFor(Experiment::circle, device_).redundancy;
  EXPECT_EQ(circle.stepFull.dir, device_.redundancy.stepFull.dir);
  const RedundancySettings heights = deviceFor(Experiment::heights, device_).redundancy;
  EXPECT_EQ(heights.stepFull.dir, 2.1);
  EXPECT_EQ(heights.stepPartitioned.cond, 0.53);
  EXPECT_EQ(heights.translationWeight, 1);
  EXPECT_EQ(heights.rotationWeight, 2);
}

}  // namespace
}  // namespace haptiv
