#include "app/devicecheck/WorkspaceTour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "device/kinematics/ArmKinematics.h"

namespace haptiv {
namespace {

/// A workspace that VISHARD10 goes through in a moment.
constexpr Specification kSmall{.diameter = 0.4, .height = 0.2};
constexpr TourGrid kCoarse{.layers = 1, .lines = 0.1, .turnLayers = 1, .turnRings = 0.2, .turnPlaces = 2};

TEST(WorkspaceTour, ComesToEveryPlaceOfTheSweepAndNearNoneBeside) {
  const DeviceDescription device = loadDeviceDescription("vishard10");
  const Tour tour = tourWorkspace(device, {}, kSmall, kCoarse, nullptr);
  EXPECT_EQ(tour.placesMissed, 0);
  const auto onGrid =
      std::count_if(tour.samples.begin(), tour.samples.end(), [](const TourSample& sample) { return sample.onGrid; });
  EXPECT_EQ(onGrid, 13);  // of the grid of 0.1 m, these lie within 0.2 m
  EXPECT_EQ(tour.places, 13 + 3);
}

TEST(WorkspaceTour, IsADeedOfTheArm) {
  const DeviceDescription device = loadDeviceDescription("vishard10");
  const ArmKinematics arm(device);
  const Matrix3 R_home = arm.forward(device.homeAngles).rotation;
  double largestTurn = 0;
  for (const TourSample& sample : tourWorkspace(device, {}, kSmall, kCoarse, nullptr).samples) {
    const Pose X_BT = arm.forward(sample.q);
    EXPECT_NEAR((X_BT.position - sample.position).norm(), sample.placeError, 1e-12);
    largestTurn = std::max(largestTurn, (X_BT.rotation - R_home).norm());
  }
  EXPECT_NEAR(largestTurn, 2 * std::sqrt(2), 1e-2);  // half a turn, the farthest there is
}

TEST(WorkspaceTour, SaysWhatWasOutOfReach) {
  const DeviceDescription device = loadDeviceDescription("vishard10");
  Specification large = kSmall;
  large.diameter = 4;
  TourGrid grid = kCoarse;
  grid.lines = 2;
  grid.turnRings = 2;
  const Tour tour = tourWorkspace(device, {}, large, grid, nullptr);
  EXPECT_GT(tour.placesMissed, 0);
  for (const TourSample& sample : tour.samples) {
    EXPECT_TRUE(sample.q.allFinite());
    EXPECT_TRUE(std::isfinite(sample.figures.speed));
  }
}

TEST(WorkspaceTour, TellsHowFarItHasCome) {
  std::atomic<int> parts = 0;
  tourWorkspace(loadDeviceDescription("vishard10"), {}, kSmall, kCoarse, [&] { ++parts; });
  EXPECT_EQ(parts, tourParts(kCoarse));
}

}  // namespace
}  // namespace haptiv
