#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "device/simulated/ScriptedHand.h"
#include "device/simulated/SimulatedDevice.h"
#include "haptics/servo/FastLoop.h"

namespace haptiv {
namespace {

/// Hand, arm, drives, sensor, encoders, kinematics, admittance and scene together; the ball's position is that of the
/// joint angles.
class WholeChain : public ::testing::Test {
 protected:
  WholeChain() { home = Vishard10(description.links).forward(description.homeAngles).position; }

  /// Runs `seconds` with a hand that goes along the waypoints (in B, from home).
  std::vector<TickRecord> run(HapticScene scene, std::vector<HandWaypoint> way, double seconds) const {
    for (HandWaypoint& point : way) point.position += home;
    computeBounds(scene);
    SimulatedDevice device(description, description.homeAngles, std::make_unique<ScriptedHand>(way), 1);
    std::vector<TickRecord> records;
    runFast(device, description, 1000, scene, static_cast<std::uint64_t>(1000 * seconds),
            [&](const TickRecord& record) {
              EXPECT_EQ(record.faults, kNoFault) << "tick " << record.tick;
              records.push_back(record);
              return record.faults == kNoFault;
            });
    return records;
  }
  /// Mean over the last `count` ticks: the sensor's noise is not what is asked for.
  template <typename Of>
  static double mean(const std::vector<TickRecord>& records, std::size_t count, Of of) {
    double sum = 0;
    for (std::size_t i = records.size() - count; i < records.size(); ++i) sum += of(records[i]);
    return sum / static_cast<double>(count);
  }
  HapticScene wallAt(const Vector3& faceFromHome, double thickness) const {
    Wall wall;
    wall.id = 1;
    wall.shape.centre = home + faceFromHome + Vector3(thickness / 2, 0, 0);
    wall.shape.axes = Vector3(thickness / 2, 0.3, 0.3).asDiagonal();
    HapticScene scene;
    scene.walls = {wall};
    return scene;
  }
  HapticScene zoneAround(Zone zone) const {
    zone.id = 1;
    zone.shape.centre = home;
    zone.shape.axes = Vector3(0.4, 0.4, 0.4).asDiagonal();
    HapticScene scene;
    scene.zones = {zone};
    return scene;
  }

  DeviceDescription description = loadDeviceDescription("vishard10");
  Vector3 home;
};

TEST_F(WholeChain, RestsTenMillimetresDeepUnderTwentyNewtons) {
  const HapticScene scene = wallAt({0.05, 0, 0}, 0.1);
  // Where the hand has to be for 20 N of its spring: the ball's resting place and 20 N / 400 N/m beyond.
  const double rest = 0.05 - 0.01 + 0.01;
  const double target = rest + 20 / description.hand.stiffness;
  const std::vector<TickRecord> records = run(scene, {{0, {0, 0, 0}}, {1, {target, 0, 0}}}, 5);
  const double force = mean(records, 500, [](const TickRecord& r) { return r.handForce.x(); });
  const double depth = mean(records, 500, [&](const TickRecord& r) { return r.position.x() - home.x() + 0.01 - 0.05; });
  EXPECT_NEAR(force, 20, 0.02 * 20);
  EXPECT_NEAR(depth, 0.010, 0.02 * 0.010);
  EXPECT_EQ(records.back().contacts, 1);
  EXPECT_NEAR(records.back().environmentForce.x(), -20, 0.02 * 20);
}

TEST_F(WholeChain, ComesToRestAtTheLabyrinthsStiffestWalls) {
  for (const double speed : {0.05, 0.5}) {  // m/s
    HapticScene scene = wallAt({0.05, 0, 0}, 0.1);
    scene.walls[0].surface.stiffness = 9000;
    scene.walls[0].surface.damping = 190;  // sqrt(2 m k), eq. (33)
    const double target = 0.05 - 0.01 + 20. / 9000 + 20 / description.hand.stiffness;
    const std::vector<TickRecord> records = run(scene, {{0, {0, 0, 0}}, {target / speed, {target, 0, 0}}}, 4);
    double strongest = 0, weakest = 1000;
    for (std::size_t i = records.size() - 500; i < records.size(); ++i) {
      strongest = std::max(strongest, records[i].handForce.norm());
      weakest = std::min(weakest, records[i].handForce.norm());
    }
    EXPECT_LT(strongest - weakest, 0.2);  // the sensor's noise, six standard deviations either way
    EXPECT_NEAR(strongest, 20, 0.5);
  }
}

TEST_F(WholeChain, DoesNotLetTheHardestHandThroughAThinWall) {
  const HapticScene scene = wallAt({0.03, 0, 0}, 0.005);
  const std::vector<TickRecord> records =
      run(scene, {{0, {0, 0, 0}}, {1.5, {0.6, 0, 0}}, {3, {0.6, 0, 0}}, {4, {0, 0, 0}}}, 6);
  double deepest = 0;
  for (const TickRecord& record : records) deepest = std::max(deepest, record.penetration);
  EXPECT_GT(deepest, 0.08);                                 // 170 N / 2000 N/m
  EXPECT_LT(records.back().position.x(), home.x() + 0.02);  // and back it comes on its own side
}

TEST_F(WholeChain, MovesAtTheSpeedAtWhichZoneAndFreeDampingBalanceTheHand) {
  Zone zone;
  zone.kind = Zone::Kind::viscous;
  zone.damping = 15;
  const HapticScene scene = zoneAround(zone);
  // The hand leads at constant speed; in the steady state the ball follows at that speed, under the force it takes.
  const std::vector<TickRecord> records = run(scene, {{0, {-0.1, 0, 0}}, {1, {-0.1, 0, 0}}, {4, {0.2, 0, 0}}}, 4);
  const double force = mean(records, 1000, [](const TickRecord& r) { return r.handForce.x(); });
  const TickRecord& first = records[records.size() - 1001];
  const double speed = records.back().position.x() - first.position.x();  // over one second
  EXPECT_NEAR(speed, force / (5 + 15), 0.02 * speed);
  EXPECT_NEAR(speed, 0.1, 0.002);
}

TEST_F(WholeChain, RestsInASpringZoneWhereForceOverStiffnessSays) {
  Zone zone;
  zone.kind = Zone::Kind::spring;
  zone.stiffness = 150;
  zone.anchor = home;
  const std::vector<TickRecord> records = run(zoneAround(zone), {{0, {0, 0, 0}}, {1, {0, 0.1, 0.05}}}, 6);
  for (const int axis : {1, 2}) {
    const double force = mean(records, 500, [&](const TickRecord& r) { return r.handForce[axis]; });
    const double offset = mean(records, 500, [&](const TickRecord& r) { return r.position[axis] - home[axis]; });
    EXPECT_NEAR(offset, force / 150, 0.02 * offset);
    EXPECT_GT(offset, 0.02);
  }
}

TEST_F(WholeChain, StaysWhereItIsWhenNobodyHoldsIt) {
  const std::vector<TickRecord> records = run({}, {}, 5);
  // 0.02 N of sensor noise on 2 kg and 5 N s/m walks by some tenths of a millimetre.
  EXPECT_LT((records.back().position - home).norm(), 1e-3);
}

TEST_F(WholeChain, GivesTheSameBitsTwice) {
  const HapticScene scene = wallAt({0.03, 0, 0}, 0.02);
  const std::vector<HandWaypoint> way = {{0, {0, 0, 0}}, {1, {0.1, 0.05, -0.02}}};
  const std::vector<TickRecord> a = run(scene, way, 2);
  const std::vector<TickRecord> b = run(scene, way, 2);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].reading.sensorCounts, b[i].reading.sensorCounts);
    EXPECT_EQ(a[i].command.jointRates, b[i].command.jointRates);
  }
}

}  // namespace
}  // namespace haptiv
