#include "haptics/contact/Hysteresis.h"

#include <gtest/gtest.h>

#include <cmath>

#include "haptics/laws/IfThenRenderer.h"
#include "tests/haptics/RandomShapes.h"
#include "tests/haptics/meshes/SampleMeshes.h"

namespace haptiv {
namespace {

using testing::boxSoup;
using testing::kRest;
using testing::meshWall;
using testing::RandomShapes;
using testing::sceneOf;
using testing::wallBelow;

constexpr double kHysteresis = 0.001;

/// A floor at z = 0, exact or of triangles.
class HysteresisOf : public ::testing::TestWithParam<bool> {
 protected:
  HysteresisOf() {
    Wall wall = GetParam() ? meshWall(boxSoup({0, 0, -0.05}, Vector3(1, 1, 0.05).asDiagonal(), 4)) : wallBelow(0.1);
    wall.surface.hysteresis = kHysteresis;
    scene = sceneOf({wall});
  }
  double forceAt(double depth) { return renderWalls(scene, {{0.1, 0, 0.01 - depth}, kRest, 0.01}, contacts).z(); }

  HapticScene scene;
  ContactSet contacts;
};
INSTANTIATE_TEST_SUITE_P(Box, HysteresisOf, ::testing::Values(false));
INSTANTIATE_TEST_SUITE_P(Mesh, HysteresisOf, ::testing::Values(true));

TEST_P(HysteresisOf, FeelsShallowerByItOnTheWayOut) {
  for (double d = -1e-3; d < 0.005; d += 1e-5) EXPECT_NEAR(forceAt(d), 2000 * std::max(0.0, d), 1e-3);
  for (double d = 0.005 - kHysteresis; d > -1e-3; d -= 1e-5)
    EXPECT_NEAR(forceAt(d), 2000 * std::max(0.0, d - kHysteresis), 1e-3);
  EXPECT_EQ(contacts.count, 0);
}

TEST_P(HysteresisOf, TakesItsPartOfEveryRoundTrip) {
  double last = forceAt(-1e-3), work = 0;
  for (int i = 1; i <= 2000; ++i) {
    const double d = 0.005 * std::sin(i * M_PI / 2000), before = 0.005 * std::sin((i - 1) * M_PI / 2000);
    const double force = forceAt(d);
    work += 0.5 * (force + last) * (d - before);
    last = force;
  }
  EXPECT_NEAR(work, 2000 * kHysteresis * (0.005 - kHysteresis), 1e-5);  // put in, and not given back
}

TEST_P(HysteresisOf, NeverPullsNorStepsNorGivesEnergy) {
  RandomShapes random(1);
  double d = -1e-3, last = forceAt(d), work = 0, least = 0;
  for (int tick = 0; tick < 20000; ++tick) {
    const double step = 2e-4 * random.between(-1, 1) - 0.01 * (d - 0.001);
    d += step;
    const double force = forceAt(d);
    EXPECT_GE(force, 0);
    EXPECT_LE(std::abs(force - last), 2 * 2000 * std::abs(step) + 1e-3);
    work += 0.5 * (force + last) * step;
    // What the wall can give back at most is what an ideal spring would: k f^2 / 2 k^2.
    least = std::min(least, work - 0.5 * force * force / 2000);
    last = force;
  }
  EXPECT_GT(least, -1e-4);
  EXPECT_GT(work, 0);
}

}  // namespace
}  // namespace haptiv
