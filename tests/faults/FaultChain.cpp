#include "tests/faults/FaultChain.h"

#include <algorithm>

namespace haptiv::faults {
namespace {

constexpr double kStill = 0.005;  // [m/s] of the tool at rest

/// Does what the case says.
class CaseHand : public HandSource {
 public:
  explicit CaseHand(const Operator& hand) : hand_(hand) {}
  HandTarget at(double) noexcept override { return hand_.target; }

 private:
  const Operator& hand_;
};

/// How fast the real tool is, whatever the host is told [m/s].
double speedOf(const ArmKinematics& arm, const SimulatedDevice::Truth& truth) {
  return (arm.evaluate(truth.angles).J_BT.topRows<3>() * truth.rates).norm();
}

/// Adds a tick to what came of the fault.
void add(Outcome& outcome, const TickRecord& record, double speed, double handForce, int since) {
  outcome.faults = record.faults;
  outcome.state = record.state;
  outcome.clamps |= record.clamps;
  if (outcome.found < 0 && record.faults != kNoFault) outcome.found = since + 1;
  if (outcome.safe < 0 && !record.command.enabled) outcome.safe = since + 1;
  if (speed > kStill) outcome.atRest = -1;
  if (speed <= kStill && outcome.atRest < 0) outcome.atRest = since + 1;
  outcome.force = std::max(outcome.force, record.environmentForce.norm());
  outcome.speed = std::max(outcome.speed, speed);
  outcome.handForce = std::max(outcome.handForce, handForce);
}

}  // namespace

FaultChain::FaultChain() : description(loadDeviceDescription("vishard10")) {
  home_ = ArmKinematics(description).forward(description.homeAngles).position;
  Wall wall;
  wall.id = 1;
  wall.shape.centre = home_ + Vector3(0.16, 0, 0);  // its face is 50 mm from the ball
  wall.shape.axes = Vector3(0.1, 0.6, 0.3).asDiagonal();
  scene.walls = {wall};
  scene.version = 1;
}

Outcome FaultChain::run(double injectAt, double goesOn, const Script& script) {
  SimulatedDevice device(description, description.homeAngles, std::make_unique<CaseHand>(hand), 1);
  const HapticTick tick(description, 1 / kRate);
  const ArmKinematics arm(description);
  TickState state;
  Outcome outcome;
  Vector3 lastForce = Vector3::Zero();
  const auto injection = static_cast<std::int64_t>(injectAt * kRate);
  const auto end = injection + static_cast<std::int64_t>(goesOn * kRate);
  device.start(1 / kRate);
  for (ticks_ = 0; ticks_ < end; ++ticks_) {
    const auto since = static_cast<int>(ticks_ - injection);
    const DeviceReading truth = device.read();
    reading = truth;
    hostSilent = false;
    script(*this, since);
    const TickRecord record = tick(scene, reading, state, missedTicks);
    if (since >= 0) {
      const SimulatedDevice::Truth real = device.truth();
      add(outcome, record, speedOf(arm, real), real.hand.force.norm(), since);
      outcome.forceStep = std::max(outcome.forceStep, (record.environmentForce - lastForce).norm());
    }
    lastForce = record.environmentForce;
    device.inject({.hostSilent = hostSilent});
    device.write(record.command);
  }
  device.stop();
  return outcome;
}

void pressOnWall(FaultChain& chain) {
  // 20 N: 10 mm into 2000 N/m, and the hand's spring of 400 N/m 50 mm beyond.
  const double far = 0.05 + 0.01 + 20 / chain.description.hand.stiffness;
  const double share = std::clamp(chain.time() / 0.5, 0.0, 1.0);
  chain.hand.target.holding = true;
  chain.hand.target.position = chain.home() + share * Vector3(far, 0, 0);
}

void carryFast(FaultChain& chain) {
  chain.hand.target.holding = true;
  const double y = chain.time() < 0.7 ? -0.3 * chain.time() / 0.7 : -0.3 + (chain.time() - 0.7);
  chain.hand.target.position = chain.home() + Vector3(0, std::min(y, 0.35), 0);
}

}  // namespace haptiv::faults
