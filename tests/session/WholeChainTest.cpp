#include <gmock/gmock.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <thread>

#include "tests/session/SessionFixtures.h"

// Hand, simulated arm, inverse kinematics, scene, log, and back: the ball's place is that of the joint angles.

namespace haptiv {
namespace {

using ::testing::HasSubstr;
using namespace haptiv::testing;

/// Runs with a log, and gives the log's ticks of the last `seconds`.
std::vector<TickRecord> lastTicks(SessionSetup setup, double duration, double seconds) {
  const TemporaryFolder folder;
  setup.log = folder / "s.h5";
  runFast(setup, duration);
  const SessionLog log(*setup.log);
  EXPECT_TRUE(log.complete());
  const auto count = static_cast<std::uint64_t>(seconds * setup.rate);
  return log.ticks(log.tickCount() - count, count);
}

Vector3 meanOf(const std::vector<TickRecord>& ticks, Vector3 TickRecord::*member) {
  Vector3 sum = Vector3::Zero();
  for (const TickRecord& tick : ticks) sum += tick.*member;
  return sum / static_cast<double>(ticks.size());
}

TEST(WholeChain, TwentyNewtonsRestTenMillimetresDeepInAWall) {
  const SessionSetup setup = setupFor(wallScene(2000));
  constexpr double kTouch = 0.05 - 0.01;  // the ball's centre when it touches the wall [m]
  constexpr double kForce = 20;
  constexpr double kDepth = kForce / 2000;
  const double target = kTouch + kDepth + kForce / setup.description.hand.stiffness;
  const auto ticks = lastTicks(setupFor(wallScene(2000), {{0, Vector3::Zero()}, {1, Vector3(target, 0, 0)}}), 5, 0.5);
  const double depth = meanOf(ticks, &TickRecord::position).x() - kTouch;
  EXPECT_NEAR(depth, kDepth, 0.02 * kDepth);  // 2 % as the project promises
  EXPECT_NEAR(meanOf(ticks, &TickRecord::environmentForce).x(), -kForce, 0.02 * kForce);
  EXPECT_EQ(ticks.back().faults, kNoFault);
}

TEST(WholeChain, AFreePushInADampingZoneReachesForceOverDamping) {
  constexpr double kSpeed = 0.15;  // of the hand's target [m/s]
  const SessionSetup setup = setupFor(zoneScene(Zone::Kind::viscous), {{0, Vector3::Zero()}, {2, {0, 2 * kSpeed, 0}}});
  const auto ticks = lastTicks(setup, 2, 0.8);
  const double time = static_cast<double>(ticks.back().time - ticks.front().time) / 1e9;
  const double speed = (ticks.back().position - ticks.front().position).y() / time;
  const double force = meanOf(ticks, &TickRecord::handForce).y();
  const double expected = force / (setup.scene->tool.damping + setup.scene->zones[0].damping);
  EXPECT_GT(force, 1);
  EXPECT_NEAR(speed, expected, 0.02 * expected);
}

TEST(WholeChain, ASpringZoneRestsAtForceOverStiffness) {
  constexpr double kTarget = 0.11;
  const SessionSetup setup = setupFor(zoneScene(Zone::Kind::spring), {{0, Vector3::Zero()}, {1, {kTarget, 0, 0}}});
  const auto ticks = lastTicks(setup, 5, 0.5);
  const double offset = meanOf(ticks, &TickRecord::position).x();
  const double force = setup.description.hand.stiffness * (kTarget - offset);  // of the hand's spring
  const double expected = force / setup.scene->zones[0].stiffness;
  EXPECT_GT(force, 5);
  EXPECT_NEAR(offset, expected, 0.02 * expected);
}

TEST(WholeChain, AScaledAndTurnedDeviceLeavesTheWallWhereItIs) {
  HapticScene scene = wallScene();
  scene.device.scale = 0.5;
  scene.device.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // x_B along y_W
  scene.device.position = Vector3(0, -0.175, 0);        // home again 0.35 m along x_B
  const auto ticks = lastTicks(setupFor(scene, {{0, Vector3::Zero()}, {1, Vector3(0.1, 0, 0)}}), 4, 0.2);
  const double depth = ticks.back().position.x() - 0.04;
  EXPECT_GT(depth, 0);
  EXPECT_NEAR(ticks.back().environmentForce.x(), -2000 * depth, 0.02 * 2000 * depth);
  EXPECT_NEAR(ticks.back().position.y(), 0, 1e-3);
}

TEST(FastSession, GivesTheSameBytesTwice) {
  const TemporaryFolder folder;
  SessionSetup setup = setupFor(wallScene(), {{0, Vector3::Zero()}, {0.5, Vector3(0.1, 0.02, 0)}});
  std::vector<std::string> files;
  for (const char* name : {"a.h5", "b.h5"}) {
    setup.log = folder / name;
    std::this_thread::sleep_for(files.empty() ? std::chrono::milliseconds(0) : std::chrono::milliseconds(1100));
    runFast(setup, 3);  // a second later, as HDF5 likes to write the time of day into files
    std::ifstream stream(*setup.log, std::ios::binary);
    files.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  EXPECT_GT(files[0].size(), 10'000u);
  // All bytes but HDF5's superblock, in whose extension it writes the time of day, whatever it is asked for.
  constexpr std::size_t kSuperblock = 128;
  EXPECT_TRUE(files[0].substr(kSuperblock) == files[1].substr(kSuperblock));
  setup.seed = 2;
  runFast(setup, 3);
  const SessionLog one(folder / "a.h5"), other(folder / "b.h5");
  EXPECT_FALSE(sameRecord(one.ticks(1000, 1).at(0), other.ticks(1000, 1).at(0)));  // another noise of the sensor
}

TEST(FastSession, SumsUpEveryTick) {
  const TemporaryFolder folder;
  SessionSetup setup = setupFor(
      wallScene(), {{0, Vector3::Zero()}, {1, {0.1, 0, 0}}, {2, {-0.02, 0, 0}}, {3, {0.1, 0, 0}}, {4, {0.1, 0, 0}}});
  setup.log = folder / "s.h5";
  const SessionSummary summary = runFast(setup, 4);
  const std::vector<TickRecord> ticks = SessionLog(*setup.log).ticks(0, 10'000);
  double force = 0, penetration = 0;
  for (const TickRecord& tick : ticks) {
    force = std::max(force, tick.environmentForce.norm());
    penetration = std::max(penetration, tick.penetration);
  }
  EXPECT_EQ(summary.ticks, 4000u);
  EXPECT_EQ(ticks.size(), 4000u);
  EXPECT_EQ(summary.missedTicks, 0u);
  EXPECT_EQ(summary.maxForce, force);
  EXPECT_EQ(summary.maxPenetration, penetration);
  EXPECT_GE(summary.contacts, 2u);
  EXPECT_LE(summary.contacts, 4u);  // a ball that comes fast may bounce once each time
  EXPECT_TRUE(sameRecord(summary.last, ticks.back()));
  EXPECT_EQ(ticks[1234].time, 1'234'000'000);
}

TEST(FastSession, CountsEveryTimeTheBallComesToTouch) {
  SessionSummary summary;
  for (const int contacts : {0, 1, 1, 2, 0, 1}) {
    TickRecord record;
    record.contacts = contacts;
    summary.take(record);
  }
  EXPECT_EQ(summary.contacts, 3u);
  EXPECT_EQ(summary.ticks, 6u);
}

TEST(FastSession, RefusesWhatCannotBeRun) {
  const TemporaryFolder folder;
  SessionSetup setup = setupFor(wallScene());
  setup.log = folder / "no/s.h5";
  EXPECT_THAT(messageOf([&] { runFast(setup, 1); }), HasSubstr("the folder does not exist"));
  setup = setupFor(wallScene());
  setup.rate = 0;
  EXPECT_THAT(messageOf([&] { runFast(setup, 1); }), HasSubstr("rate"));
  EXPECT_THAT(messageOf([&] { runFast(setupFor(wallScene()), std::nan("")); }), HasSubstr("seconds"));
  HapticScene far = wallScene();
  far.device.position = Vector3(5, 0, 0);
  EXPECT_THAT(messageOf([&] { runFast(setupFor(far), 1); }), HasSubstr("out of the arm's reach"));
}

TEST(FastSession, RefusesASceneThatItsLogCouldNotGiveBack) {
  std::vector<HapticScene> wrong(4, wallScene());
  wrong[0].walls[0].surface.stiffness = std::nan("");
  wrong[1].tool.mass = 0;
  wrong[2].walls[0].shape.axes(1, 2) = std::numeric_limits<double>::infinity();
  wrong[3].device.position.y() = std::nan("");
  const std::vector<std::string> told = {"stiffness of the wall", "mass of the tool", "size of the wall",
                                         "position of the device"};
  for (std::size_t i = 0; i < wrong.size(); ++i)
    EXPECT_THAT(messageOf([&] { runFast(setupFor(wrong[i]), 1); }), HasSubstr(told[i]));
}

}  // namespace
}  // namespace haptiv
