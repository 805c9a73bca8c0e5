#include "haptics/HapticTick.h"

#include <algorithm>

#include "haptics/Zones.h"

namespace haptiv {
namespace {

bool isFinite(const TickState& state, const DeviceCommand& command) noexcept {
  return state.control.allFinite() && state.fade.felt.allFinite() && command.jointRates.allFinite() &&
         command.jointTorques.allFinite();
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
  record.desiredAngles = state.control.desiredAngles;
  record.position = measured.p_WT;
  record.desiredPosition = state.control.admittance.position;
  record.desiredVelocity = state.control.admittance.velocity;
  record.handForce = measured.handForce;
  record.handTorque = measured.handTorque;
  record.state = state.session;
  return record;
}

}  // namespace

HapticTick::HapticTick(const DeviceDescription& description, double period)
    : period_(period),
      measure_(description, period),
      monitors_(description),
      passivity_(description, period),
      control_(description, period) {}

void HapticTick::feel(const HapticScene& scene, const ToolMotion& tool, TickState& state,
                      TickRecord& record) const noexcept {
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

TickRecord HapticTick::operator()(const HapticScene& scene, const DeviceReading& reading, TickState& state,
                                  std::uint32_t missedTicks) const noexcept {
  const Measured measured = measure_(scene.device, reading, state.measuring);
  const ControlChoice choice = control_.choiceFor(scene);
  const bool isLed = state.started && choice.display != DisplayMode::impedance;
  state.faults |= monitors_(reading, measured, isLed ? &state.control.desiredAngles : nullptr);
  if (!state.started) {
    control_.begin(measured, state.control);
    state.passivity = {};
    state.started = true;
  }
  if (state.faults == kNoFault) control_.follow(choice, measured, state.control);
  state.session = state.faults == kNoFault ? SessionState::running : SessionState::fault;
  TickRecord record = recordOf(scene, reading, measured, state);
  record.missedTicks = missedTicks;
  if (state.faults == kNoFault) {
    TickState next = state;
    TickRecord moved = record;
    feel(scene, control_.felt(choice, scene, measured, next.control), next, moved);
    const Vector3 damped =
        passivity_(choice, scene, measured, next.control.admittance, next.contacts, next.passivity, moved);
    moved.command = control_(choice, scene, measured, moved.environmentForce + damped, next.contacts, next.control);
    if (isFinite(next, moved.command)) {
      state = next;
      return moved;
    }
    state.faults |= kFaultNotFinite;
    state.session = record.state = SessionState::fault;
  }
  state.control.admittance.velocity.setZero();
  state.control.handle.rate.setZero();
  state.fade.felt.setZero();
  record.faults = state.faults;
  return record;
}

}  // namespace haptiv
