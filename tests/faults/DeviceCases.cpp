#include <cmath>

#include "tests/faults/FaultCases.h"

namespace haptiv::faults {
namespace {

using Chain = FaultChain;

/// What the operator does, and from the injection on, what is spoilt.
template <typename Spoil>
Chain::Script pressing(Spoil spoil) {
  return [spoil](Chain& chain, int since) mutable {
    pressOnWall(chain);
    if (since >= 0) spoil(chain, since);
  };
}
/// An operator who carries the ball when the arm stops lets go, startled, after the time of a reaction.
template <typename Spoil>
Chain::Script carrying(Spoil spoil) {
  constexpr int kReaction = 150;  // [ticks]
  return [spoil](Chain& chain, int since) mutable {
    carryFast(chain);
    if (since >= kReaction) chain.hand.target.holding = false;
    if (since >= 0) spoil(chain, since);
  };
}

void release(Chain& chain, int) {
  chain.reading.inputs &= static_cast<std::uint16_t>(~kInputDeadMan);
}
void stopButton(Chain& chain, int) {
  chain.reading.inputs |= kInputEmergencyStop2;
}
void disconnect(Chain& chain, int) {
  chain.reading.connected = false;
}

/// The sensor's axis tells `counts` more than it should.
auto axisOff(std::size_t axis, int counts) {
  return [axis, counts](Chain& chain, int) {
    chain.reading.sensorCounts[axis] = static_cast<std::int16_t>(chain.reading.sensorCounts[axis] + counts);
  };
}
/// Axes [first, last) tell what they told at the injection, for ever.
auto axesFrozen(std::size_t first, std::size_t last) {
  return [first, last, kept = std::array<std::int16_t, 6>{}](Chain& chain, int since) mutable {
    if (since == 0) kept = chain.reading.sensorCounts;
    for (std::size_t i = first; i < last; ++i) chain.reading.sensorCounts[i] = kept[i];
  };
}
/// A joint's encoder tells what it told at the injection, for ever.
auto encoderFrozen(std::size_t joint) {
  return [joint, kept = std::int32_t{0}](Chain& chain, int since) mutable {
    if (since == 0) kept = chain.reading.encoderCounts[joint];
    chain.reading.encoderCounts[joint] = kept;
  };
}
/// Joint 3's encoder is off by so many counts, and by so many more with every tick.
auto encoderOff(double counts, double perTick) {
  return [=](Chain& chain, int since) {
    chain.reading.encoderCounts[2] += static_cast<std::int32_t>(counts + perTick * since);
  };
}

}  // namespace

FaultGroup operatorFaults() {
  return {"The operator",
          {{"dead-man released in contact", kNoFault, kNoClamp, SessionState::ready, 1, pressing(release)},
           {"dead-man released at 1 m/s", kNoFault, kNoClamp, SessionState::ready, 1, carrying(release)},
           {"emergency stop in contact", kFaultEmergencyStop, kNoClamp, SessionState::fault, 1, pressing(stopButton)},
           {"emergency stop at 1 m/s", kFaultEmergencyStop, kNoClamp, SessionState::fault, 1, carrying(stopButton)}}};
}

FaultGroup sensorFaults() {
  const auto step = [](FaultCase at) { return at; };
  return {
      "The handle's sensor",
      {step({"an axis at the end of its range", kFaultSensorSaturated, kNoClamp, SessionState::fault, 1,
             pressing([](Chain& chain, int) { chain.reading.sensorCounts[1] = -20000; })}),
       {"an axis stuck", kFaultSensorStuck, kNoClamp, SessionState::fault, 101, pressing(axesFrozen(4, 5))},
       {"the sensor's cable is cut: all axes tell zero", kFaultSensorStuck, kNoClamp, SessionState::fault, 101,
        pressing([](Chain& chain, int) { chain.reading.sensorCounts = {}; })},
       {"all axes stuck at 1 m/s", kFaultSensorStuck, kNoClamp, SessionState::fault, 101, carrying(axesFrozen(0, 6))},
       {"a force that no hand has (310 N)", kFaultHandForce, kNoClamp, SessionState::fault, 1,
        pressing(axisOff(2, 15500))}}};
}

FaultGroup encoderFaults() {
  return {"Encoders and joints",
          {{"an encoder jumps by 0.1 rad", kFaultEncoderJump, kNoClamp, SessionState::fault, 1,
            pressing(encoderOff(6519, 0))},
           {"an encoder stands still at 1 m/s: joint 1", kFaultEncoderStuck, kNoClamp, SessionState::fault, 10,
            carrying(encoderFrozen(0))},
           {"an encoder stands still at 1 m/s: joint 3", kFaultEncoderStuck, kNoClamp, SessionState::fault, 10,
            carrying(encoderFrozen(2))},
           {"the same under computed torque: joint 3", kFaultEncoderStuck, kNoClamp, SessionState::fault, 10,
            carrying(encoderFrozen(2)), 1, 0.5,
            [](Chain& chain) { chain.description.control.choice.joints = JointController::computedTorque; }},
           {"an encoder runs away, a joint seems too fast", kFaultJointSpeed, kNoClamp, SessionState::fault, 2,
            pressing(encoderOff(0, 1000))},
           {"an encoder slips by 5 rad/s, the tool seems too fast", kFaultToolSpeed, kNoClamp, SessionState::fault, 5,
            pressing(encoderOff(0, 326))},
           {"an encoder slips by 3.5 rad/s", kFaultTracking, kNoClamp, SessionState::fault, 400,
            pressing(encoderOff(0, 228)), 1, 1}}};
}

FaultGroup connectionFaults() {
  return {
      "The connection, and the servo",
      {{"device disconnected in contact", kFaultDisconnected, kNoClamp, SessionState::fault, 1, pressing(disconnect)},
       {"device disconnected at 1 m/s", kFaultDisconnected, kNoClamp, SessionState::fault, 1, carrying(disconnect)},
       {"device gone for one tick and back", kFaultDisconnected, kNoClamp, SessionState::fault, 1,
        carrying([](Chain& chain, int since) { chain.reading.connected = since > 0; })},
       {"600 ticks missed at once", kFaultMissedTicks, kNoClamp, SessionState::fault, 1,
        pressing([](Chain& chain, int) { chain.missedTicks = 600; })},
       {"two of three ticks missed", kFaultMissedTicks, kNoClamp, SessionState::fault, 1100,
        pressing([](Chain& chain, int) { chain.missedTicks += 2; }), 1, 1.5},
       {"every command lost at 1 m/s: the board's watchdog", kFaultTripWatchdog, kNoClamp, SessionState::fault, 12,
        carrying([](Chain& chain, int) { chain.hostSilent = true; })}}};
}

FaultGroup tripFaults() {
  FaultGroup group{"Trips that the device tells", {}};
  for (int bit = 0; bit < kTripCount; ++bit) {
    const std::uint32_t trip = 1u << bit;
    group.cases.push_back({tripNames(trip).front(), faultsOfTrips(trip), kNoClamp, SessionState::fault, 1,
                           carrying([trip](Chain& chain, int) { chain.reading.trips |= trip; })});
  }
  return group;
}

}  // namespace haptiv::faults
