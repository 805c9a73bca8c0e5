#include "haptics/HapticTick.h"

#include <algorithm>

#include "device/redundancy/DriftCorrection.h"
#include "device/redundancy/JointLimiter.h"
#include "haptics/DeviceFrames.h"
#include "haptics/FreeMotion.h"
#include "haptics/Zones.h"

namespace haptiv {
namespace {

bool isFinite(const TickState& state, const TickRecord& record) noexcept {
  return state.admittance.position.allFinite() && state.admittance.velocity.allFinite() &&
         state.desiredAngles.allFinite() && state.fade.felt.allFinite() && record.command.jointRates.allFinite();
}

const Contact* deepest(const ContactSet& contacts) noexcept {
  const auto end = contacts.contact.begin() + contacts.count;
  const auto found = std::max_element(contacts.contact.begin(), end,
                                      [](const Contact& a, const Contact& b) { return a.depth < b.depth; });
  return found == end ? nullptr : &*found;
}

/// All of the record that is there before anything moves.
TickRecord recordOf(const HapticScene& scene, const DeviceReading& reading, const Measured& measured,
                    const TickState& state) noexcept {
  TickRecord record;
  record.sceneVersion = scene.version;
  record.reading = reading;
  record.jointAngles = measured.angles;
  record.desiredAngles = state.desiredAngles;
  record.position = measured.p_WT;
  record.desiredPosition = state.admittance.position;
  record.desiredVelocity = state.admittance.velocity;
  record.handForce = measured.handForce;
  record.handTorque = measured.handTorque;
  record.state = state.session;
  return record;
}

/// The virtual mass at rest where the arm is.
void startAt(const Measured& measured, TickState& state) noexcept {
  state.started = true;
  state.desiredAngles = measured.angles;
  state.heldRotation = measured.arm.X_BT.rotation;
  state.admittance = {measured.p_WT, Vector3::Zero()};
  state.passivity = {};
}

}  // namespace

HapticTick::HapticTick(const DeviceDescription& description, double period)
    : description_(description),
      period_(period),
      measure_(description, period),
      monitors_(description),
      passivity_(description, period),
      arm_(description),
      resolution_(description) {}

void HapticTick::feel(const HapticScene& scene, TickState& state, TickRecord& record) const noexcept {
  const ToolMotion tool{state.admittance.position, state.admittance.velocity, scene.tool.radius};
  const Vector3 walls = renderWalls(scene, tool, state.contacts);
  int zones = 0;
  const Vector3 raw = walls + renderZones(scene, tool, zones);
  record.environmentForce = state.fade.apply(scene, raw, period_);
  record.zones = zones;
  record.contacts = state.contacts.walls();
  if (const Contact* contact = deepest(state.contacts)) {
    record.penetration = contact->depth;
    record.deepestWall = contact->wall;
  }
}

void HapticTick::move(const HapticScene& scene, const Measured& measured, TickState& state,
                      TickRecord& record) const noexcept {
  const DevicePlacement& device = scene.device;
  const JointVector& rateLimit = description_.drives.rateLimit;
  AdmittanceState& ball = state.admittance;
  const ControlChoice control = scene.control.value_or(description_.control.choice);
  const Vector3 damped = passivity_(control, scene, measured, ball, state.contacts, state.passivity, record);
  const Vector3 force = measured.handForce + record.environmentForce + damped +
                        freeMotionForce(ball.velocity, state.contacts, scene.tool.damping);
  const Vector3 velocity = nextVelocity(ball, force, scene.tool.mass, period_);

  const Pose wanted{placeInBase(device, ball.position), state.heldRotation};
  const ArmPose arm = arm_.evaluate(state.desiredAngles);
  Vector6 twist = driftCorrection(wanted, arm.X_BT, description_.control.driftGain);
  twist.head<3>() += device.rotation.transpose() * velocity / device.scale;
  const ResolutionChoice choice = scene.resolution.value_or(description_.redundancy.choice);
  const JointVector rates = state.resolution.rates(resolution_, choice, state.desiredAngles, arm.J_BT, twist, period_);
  const double slowed = slowDownFactor(rates, rateLimit);

  const JointVector error = state.desiredAngles - measured.angles;
  const JointVector command = slowed * rates + description_.control.jointGain * error;
  record.command.jointRates = command.cwiseMin(rateLimit).cwiseMax(-rateLimit);
  record.command.enabled = true;
  state.desiredAngles += slowed * period_ * rates;
  ball.velocity = slowed * velocity;
  ball.position += period_ * ball.velocity;
}

TickRecord HapticTick::operator()(const HapticScene& scene, const DeviceReading& reading, TickState& state,
                                  std::uint32_t missedTicks) const noexcept {
  const Measured measured = measure_(scene.device, reading, state.measuring);
  state.faults |= monitors_(reading, measured, state.started ? &state.desiredAngles : nullptr);
  if (!state.started) startAt(measured, state);
  state.session = state.faults == kNoFault ? SessionState::running : SessionState::fault;
  TickRecord record = recordOf(scene, reading, measured, state);
  record.missedTicks = missedTicks;
  if (state.faults == kNoFault) {
    TickState next = state;
    TickRecord moved = record;
    feel(scene, next, moved);
    move(scene, measured, next, moved);
    if (isFinite(next, moved)) {
      state = next;
      return moved;
    }
    state.faults |= kFaultNotFinite;
    state.session = record.state = SessionState::fault;
  }
  state.admittance.velocity.setZero();
  state.fade.felt.setZero();
  record.faults = state.faults;
  return record;
}

}  // namespace haptiv
