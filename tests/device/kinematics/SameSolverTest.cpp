#include <gtest/gtest.h>

#include "device/control/ResolutionNames.h"
#include "device/kinematics/ArmKinematics.h"
#include "device/redundancy/RedundancyResolution.h"
#include "tests/device/kinematics/Chains.h"
#include "tests/support/Random.h"

namespace haptiv {
namespace {

/// VISHARD10 by its closed forms and VISHARD10 as a chain of its links, through the same solver.
TEST(SameSolver, MovesVishard10AndItsChainAlike) {
  const DeviceDescription closed = loadDeviceDescription("vishard10");
  DeviceDescription chain = closed;
  chain.chain = test::vishard10Chain(closed.links);
  const ArmKinematics closedArm(closed), chainArm(chain);
  ASSERT_NE(closedArm.vishard10(), nullptr);
  ASSERT_EQ(chainArm.vishard10(), nullptr);
  const RedundancyResolution closedSolver(closed), chainSolver(chain);
  test::Random random(1);
  for (int i = 0; i < 200; ++i) {
    // About home, where rates are of the order of the twist: rounding is not blown up.
    const JointVector q = closed.homeAngles + random.vector<JointVector>(-0.3, 0.3);
    const auto twist = random.vector<Vector6>(-1, 1);
    for (const Strategy strategy : kStrategies) {
      const ResolutionChoice choice{strategy, Solution::full};
      const JointVector a = closedSolver.rates(choice, q, closedArm.jacobian(q), twist, 1e-3);
      const JointVector b = chainSolver.rates(choice, q, chainArm.jacobian(q), twist, 1e-3);
      EXPECT_GT(a.norm(), 0.1);
      // The side criteria's steps multiply the rounding of their gradients.
      const double tolerance = strategy == Strategy::nonopt ? 1e-12 : 1e-10;
      EXPECT_LT((a - b).norm(), tolerance * std::max(1., a.norm())) << nameOf(strategy);
    }
  }
}

}  // namespace
}  // namespace haptiv
