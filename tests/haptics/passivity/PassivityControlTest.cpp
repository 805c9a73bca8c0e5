#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <vector>

#include "device/simulated/ScriptedHand.h"
#include "device/simulated/SimulatedDevice.h"
#include "haptics/passivity/PassivityController.h"
#include "haptics/passivity/PassivityObserver.h"
#include "haptics/servo/FastLoop.h"
#include "tests/haptics/RandomShapes.h"

namespace haptiv {
namespace {

constexpr double kTickPeriod = 1e-3;
constexpr double kLongestForce = 170;  // [N]

/// The plane x = 0 with what is behind it; felt `delay` ticks late, which makes it give energy.
class LateWall {
 public:
  LateWall(double stiffness, double damping, std::size_t delay)
      : stiffness_(stiffness), damping_(damping), late_(delay, 0) {}

  double force(double x, double v) {
    const double now = x > 0 ? -stiffness_ * x - damping_ * std::max(v, 0.0) : 0;
    late_.push_back(now);
    const double then = late_.front();
    late_.pop_front();
    return then;
  }

 private:
  double stiffness_, damping_;
  std::deque<double> late_;
};

struct Flight {
  std::vector<double> speeds;
  double leastEnergy = PassivityObserver::kReserve;  ///< of the observer
  double mostATick = 0;                              ///< that the wall gave in one tick [J]
  double mostDamping = 0;
  double longestForce = 0;  ///< of the controller
  double lastEnergy = 0;    ///< of the ball [J]
};

/// A ball of `mass` that nobody holds flies into the wall and out again, by the steps of the admittance.
Flight fly(LateWall wall, double speed, double mass, bool controlled) {
  Flight flight;
  PassivityObserver observer;
  Vector3 x(-0.003, 0, 0), v(speed, 0, 0);
  for (int tick = 0; tick < 2000; ++tick) {
    observer.seeMass({Vector3::Zero(), x, x, v}, mass, kTickPeriod);
    flight.leastEnergy = std::min(flight.leastEnergy, observer.energy);
    const Vector3 pushed(wall.force(x.x(), v.x()), 0, 0);
    const Vector3 next = v + kTickPeriod / mass * pushed;
    flight.mostATick = std::max(flight.mostATick, 0.5 * kTickPeriod * pushed.dot(v + next));
    const AddedDamping added =
        controlled ? dampMass(-observer.energy, next, mass, kTickPeriod, kLongestForce) : AddedDamping{};
    flight.mostDamping = std::max(flight.mostDamping, added.damping);
    flight.longestForce = std::max(flight.longestForce, added.force.norm());
    v = next + kTickPeriod / mass * added.force;
    x += kTickPeriod * v;
    flight.speeds.push_back(v.x());
  }
  flight.lastEnergy = 0.5 * mass * v.squaredNorm();
  return flight;
}

TEST(PassivityControl, KeepsAnActiveWallFromGivingMoreThanTheReserve) {
  const LateWall wall(20000, 0, 5);
  const double came = 0.5 * 2 * 0.2 * 0.2;
  const Flight alone = fly(wall, 0.2, 2, false);
  EXPECT_GT(alone.lastEnergy, 2 * came);  // the wall is active
  EXPECT_LT(alone.leastEnergy, -came);    // and the observer sees it
  const Flight controlled = fly(wall, 0.2, 2, true);
  EXPECT_GT(controlled.mostDamping, 0);
  EXPECT_LE(controlled.lastEnergy, came + PassivityObserver::kReserve + 1e-9);
  EXPECT_GE(controlled.leastEnergy, -controlled.mostATick - 1e-9);  // what it sees in a tick it takes away in the next
}

TEST(PassivityControl, DoesSoForEveryWallAndNeverPushesHarderThanTheClamp) {
  testing::RandomShapes random(3);
  for (int run = 0; run < 300; ++run) {
    const double mass = random.between(0.3, 4);
    const double speed = random.between(0.02, 0.6);
    const LateWall wall(random.between(500, 30000), random.between(0, 100), static_cast<std::size_t>(run % 6));
    const Flight flight = fly(wall, speed, mass, true);
    EXPECT_LE(flight.longestForce, kLongestForce * (1 + 1e-12));
    if (flight.longestForce < kLongestForce * (1 - 1e-9)) {
      EXPECT_LE(flight.lastEnergy, 0.5 * mass * speed * speed + PassivityObserver::kReserve + 1e-9) << "run " << run;
    }
  }
}

TEST(PassivityControl, LeavesAPassiveWallAloneToTheLastBit) {
  const LateWall wall(2000, 20, 0);
  const Flight with = fly(wall, 0.3, 2, true);
  EXPECT_EQ(with.mostDamping, 0);
  EXPECT_EQ(with.speeds, fly(wall, 0.3, 2, false).speeds);
}

TEST(PassivityControl, StopsTheMassAtMost) {
  const Vector3 v(0.1, -0.2, 0.05);
  const AddedDamping all = dampMass(1e3, v, 2, kTickPeriod, 1e9);
  const Vector3 left = v + kTickPeriod / 2 * all.force;
  EXPECT_GE(left.dot(v), 0);
  EXPECT_LT(left.norm(), 2e-3 * v.norm());
  const AddedDamping half = dampMass(0.5 * 0.5 * 2 * v.squaredNorm(), v, 2, kTickPeriod, 1e9);
  EXPECT_NEAR((v + kTickPeriod / 2 * half.force).squaredNorm(), 0.5 * v.squaredNorm(), 1e-12);
  EXPECT_LT((half.force + half.damping * (v + kTickPeriod / 2 * half.force)).norm(), 1e-9);  // f = -b v'
  EXPECT_EQ(dampMass(1, Vector3::Zero(), 2, kTickPeriod, kLongestForce).damping, 0);
  EXPECT_EQ(dampMass(-1, v, 2, kTickPeriod, kLongestForce).damping, 0);
}

/// An arm of 0.5 kg flies into a wall that it feels by its own force, as an impedance display does: sampled at 1 kHz,
/// moved in steps a hundred times as fine. What it gains [J].
double energyGainedFromAnImpedance(bool controlled) {
  constexpr double kMass = 0.5;
  constexpr double kImpedanceSpeed = 0.5;  // [m/s]
  constexpr int kFine = 100;
  LateWall wall(4000, 0, 3);
  PassivityObserver observer;
  double x = -0.0021, v = kImpedanceSpeed;
  for (int tick = 0; tick < 400; ++tick) {
    observer.seeTool({Vector3::Zero(), Vector3(x, 0, 0), Vector3::Zero(), Vector3::Zero()});
    double force = wall.force(x, v);
    if (controlled) force += dampTool(-observer.energy, Vector3(v, 0, 0), kMass, kTickPeriod, kLongestForce).force.x();
    observer.hold(Vector3(force, 0, 0));
    for (int i = 0; i < kFine; ++i) {
      v += kTickPeriod / kFine * force / kMass;
      x += kTickPeriod / kFine * v;
    }
  }
  return 0.5 * kMass * (v * v - kImpedanceSpeed * kImpedanceSpeed);
}

TEST(PassivityControl, HoldsForAnImpedanceDisplayToo) {
  EXPECT_GT(energyGainedFromAnImpedance(false), 0.05);
  EXPECT_LT(energyGainedFromAnImpedance(true), PassivityObserver::kReserve + 1e-4);
}

TEST(PassivityObserver, ForgetsWhatWasDissipatedAndNoDebt) {
  PassivityObserver observer;
  observer.energy = 5;
  observer.forgetSurplus(2);  // a spring holds that much
  EXPECT_EQ(observer.energy, PassivityObserver::kReserve + 2);
  observer.forgetSurplus(0);
  EXPECT_EQ(observer.energy, PassivityObserver::kReserve);
  observer.energy = -1;
  observer.forgetSurplus(0);
  EXPECT_EQ(observer.energy, -1);
}

/// A hand that is a spring holds an arm that follows the ball of 2 kg `kLate` ticks late, and nothing takes energy
/// away. Its energy and the ball's after two seconds, over what they had [J / J].
double energyOfALateArm(bool controlled) {
  constexpr double kMass = 2, kHand = 1000, kStart = 0.01;  // [kg], [N/m], [m]
  constexpr std::size_t kLate = 4;
  PassivityObserver observer;
  Vector3 x(kStart, 0, 0), v = Vector3::Zero();
  std::deque<Vector3> way(kLate, x);
  double energy = 0;
  for (int tick = 0; tick < 2000; ++tick) {
    way.push_back(x);
    const Vector3 tool = way.front();
    way.pop_front();
    const Vector3 force = -kHand * tool;
    observer.seeMass({force, tool, x, v}, kMass, kTickPeriod);
    energy = 0.5 * kMass * v.squaredNorm() + 0.5 * kHand * tool.squaredNorm();
    v += kTickPeriod / kMass * force;
    if (controlled) v += kTickPeriod / kMass * dampMass(-observer.energy, v, kMass, kTickPeriod, kLongestForce).force;
    x += kTickPeriod * v;
  }
  return energy / (0.5 * kHand * kStart * kStart);
}

TEST(PassivityControl, KeepsAnArmThatIsLateFromFeedingTheHand) {
  EXPECT_GT(energyOfALateArm(false), 5);
  const double reserve = PassivityObserver::kReserve / (0.5 * 1000 * 0.01 * 0.01);
  EXPECT_LT(energyOfALateArm(true), 1 + reserve + 0.1);  // a tenth: what force and lag, f . e, hold at the moment
}

/// Hand, arm and scene together.
std::vector<TickRecord> pressTheWall(double stiffness, double damping, bool controlled) {
  DeviceDescription description = loadDeviceDescription("vishard10");
  const Vector3 home = ArmKinematics(description).forward(description.homeAngles).position;
  Wall wall;
  wall.id = 1;
  wall.shape.centre = home + Vector3(0.08, 0, 0);
  wall.shape.axes = Vector3(0.05, 0.2, 0.2).asDiagonal();
  wall.surface.stiffness = stiffness;
  wall.surface.damping = damping;
  HapticScene scene;
  scene.walls = {wall};
  scene.control = description.control.choice;
  scene.control->passivity = controlled;
  computeBounds(scene);
  SimulatedDevice device(
      description, description.homeAngles,
      std::make_unique<ScriptedHand>(std::vector<HandWaypoint>{{0, home}, {0.4, home + Vector3(0.07, 0, 0)}}), 1);
  std::vector<TickRecord> records;
  runFast(device, description, 1000, scene, 1500, [&](const TickRecord& record) {
    records.push_back(record);
    return true;
  });
  return records;
}

TEST(PassivityControl, LeavesTheWholeChainAloneWhereItIsPassive) {
  const std::vector<TickRecord> with = pressTheWall(2000, 20, true);
  const std::vector<TickRecord> without = pressTheWall(2000, 20, false);
  ASSERT_EQ(with.size(), without.size());
  EXPECT_EQ(with.back().contacts, 1);
  for (std::size_t i = 0; i < with.size(); ++i) {
    ASSERT_EQ(with[i].passivityDamping, 0) << "tick " << i;
    ASSERT_GE(with[i].passivityEnergy, 0) << "tick " << i;
    ASSERT_EQ(with[i].passivityEnergy, without[i].passivityEnergy);  // it is observed all the same
    ASSERT_EQ(with[i].command.jointRates, without[i].command.jointRates);
  }
}

}  // namespace
}  // namespace haptiv
