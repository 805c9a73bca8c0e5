// A session with the simulated Falcon: a parallel arm of the impedance type, through the same tick, log and back.
#include <gmock/gmock.h>

#include "app/session/Resimulation.h"
#include "tests/session/SessionFixtures.h"

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using namespace haptiv::testing;

constexpr double kTouch = -0.01;  // of the ball's centre, along y [m]

/// A wall of 600 N/m before the operator, as in scenes/falcon-wall.iv: the device's z points back at him, along -y.
HapticScene falconWall() {
  HapticScene scene;
  scene.device.description = "falcon";
  scene.device.position = Vector3(0, 0.09, 0);
  scene.device.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  scene.tool.home = Vector3(0, -0.03, 0);
  scene.tool.damping = 1;
  Wall wall;
  wall.shape.centre = Vector3(0, 0.04, 0);
  wall.shape.axes = Vector3(0.06, 0.04, 0.06).asDiagonal();
  wall.surface.stiffness = 600;
  wall.surface.damping = 4;
  scene.walls.push_back(wall);
  computeBounds(scene);
  return scene;
}

SessionSetup falconSetup(double target) {
  SessionSetup setup = setupFor(falconWall(), {{0, Vector3(0, -0.03, 0)}, {0.5, Vector3(0.005, target, -0.005)}});
  setup.description = loadDeviceDescription("falcon");
  return setup;
}

class FalconSession : public ::testing::Test {
 protected:
  std::vector<TickRecord> lastTicks(SessionSetup setup) {
    setup.log = folder_ / "s.h5";
    runFast(setup, 3);
    return SessionLog(folder_ / "s.h5").ticks(2500, 500);
  }
  TemporaryFolder folder_;
};

TEST_F(FalconSession, ThreeNewtonsRestFiveMillimetresDeepInAWall) {
  constexpr double kForce = 3;
  const double target = kTouch + kForce / 600 + kForce / loadDeviceDescription("falcon").hand.stiffness;
  for (const TickRecord& tick : lastTicks(falconSetup(target))) {
    ASSERT_EQ(tick.faults, kNoFault);
    // The legs' dry friction of 0.004 N m carries up to 0.2 N of it, and stays.
    EXPECT_NEAR(-tick.environmentForce.y(), kForce, 0.3);
    EXPECT_NEAR(tick.position.y() - kTouch, kForce / 600, 0.3 / 600);
    EXPECT_EQ(tick.handForce, Vector3(Vector3::Zero())) << "it has no sensor";
    EXPECT_EQ(tick.command.mode, DriveMode::torque);
    EXPECT_TRUE(tick.command.jointTorques.tail<7>().isZero(0)) << "three joints";
  }
}

TEST_F(FalconSession, AHandThatPushesBeyondTheDevicesForceIsMetByNoMoreThanThat) {
  double most = 0;
  for (const TickRecord& tick : lastTicks(falconSetup(0.06))) {
    most = std::max(most, tick.environmentForce.norm());
    EXPECT_NE(tick.clamps & kClampForce, 0u);
    EXPECT_LE(tick.command.jointTorques.head<3>().cwiseAbs().maxCoeff(), 0.2);
  }
  EXPECT_NEAR(most, 8, 1e-9);
}

TEST_F(FalconSession, ItsLogReSimulatesBitForBit) {
  lastTicks(falconSetup(0.02));
  const Verification result = verify(SessionLog(folder_ / "s.h5"));
  EXPECT_TRUE(result.identical()) << result.first->field << " at " << result.first->tick;
  EXPECT_EQ(result.ticks, 3000u);
}

TEST_F(FalconSession, CanShowForcesAndNothingElse) {
  SessionSetup setup = falconSetup(0);
  HapticScene scene = *setup.scene;
  scene.control = ControlChoice{DisplayMode::admittance};
  setup.scene = std::make_shared<const HapticScene>(scene);
  EXPECT_THAT(messageOf([&] { runFast(setup, 1); }), HasSubstr("choose impedance"));
}

TEST_F(FalconSession, SaysHowFarItReaches) {
  SessionSetup setup = falconSetup(0);
  HapticScene scene = *setup.scene;
  scene.tool.home = Vector3(0, -0.2, 0);
  setup.scene = std::make_shared<const HapticScene>(scene);
  EXPECT_THAT(messageOf([&] { runFast(setup, 1); }), HasSubstr("out of the arm's reach"));
}

}  // namespace
}  // namespace haptiv
