#include "haptics/tick/HapticTick.h"

#include <algorithm>

#include "haptics/laws/Zones.h"

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
  return record;
}

/// Nothing moves any more; where the virtual mass was is kept, to be seen.
void halt(TickState& state) noexcept {
  state.control.admittance.velocity.setZero();
  state.control.handle.rate.setZero();
  state.fade.felt.setZero();
  state.clamps = kNoClamp;
}

Driven drivenBy(const ControlChoice& choice, const HapticScene& scene, const TickState& state) noexcept {
  const bool running = state.session.now == SessionState::running;
  const PassivityObserver& observer = state.passivity.observer;
  return {running,
          running && choice.display != DisplayMode::impedance,
          state.control.desiredAngles,
          {state.control.admittance.velocity / scene.device.scale, observer.heldForce, observer.energy},
          state.clamps};
}

}  // namespace

HapticTick::HapticTick(const DeviceDescription& description, double period)
    : period_(period),
      measure_(description, period),
      monitors_(description, period),
      clamps_(description, period),
      passivity_(description, period),
      control_(description, period) {}

void HapticTick::feel(const HapticScene& scene, const ToolMotion& tool, TickState& state,
                      TickRecord& record) const noexcept {
  const Vector3 walls = renderWalls(scene, tool, state.contacts);
  int zones = 0;
  const Vector3 raw = walls + renderZones(scene, tool, zones);
  record.environmentForce = clamps_.force(state.fade.apply(scene, raw, period_), record.clamps);
  record.zones = zones;
  record.contacts = state.contacts.walls();
  if (const Contact* contact = deepest(state.contacts)) {
    record.penetration = contact->depth;
    record.deepestWall = contact->wall;
  }
}

void HapticTick::settle(const Measured& measured, TickState& state) const noexcept {
  control_.begin(measured, state.control);
  state.passivity = {};
  state.contacts = {};
  state.fade = {};
  state.clamps = kNoClamp;
}

void HapticTick::run(const ControlChoice& choice, const HapticScene& scene, const Measured& measured, TickState& state,
                     TickRecord& record) const noexcept {
  feel(scene, control_.felt(choice, scene, measured, state.control), state, record);
  const FeltScene felt{state.contacts, record.zones, record.environmentForce};
  const AddedDamping added = passivity_(choice, scene, measured, state.control.admittance, felt, state.passivity);
  record.passivityEnergy = state.passivity.observer.energy;
  record.passivityDamping = added.damping;
  const Vector3 shown = clamps_.force(record.environmentForce + added.force, record.clamps);
  state.passivity.observer.hold(shown);
  record.command = control_(choice, scene, measured, shown, state.contacts, state.control, record.clamps);
  state.clamps = record.clamps;
}

TickRecord HapticTick::operator()(const HapticScene& scene, const DeviceReading& reading, TickState& state,
                                  std::uint32_t missedTicks) const noexcept HAPTIV_NONBLOCKING {
  const Measured measured = measure_(scene.device, reading, state.measuring);
  const ControlChoice choice = control_.choiceFor(scene);
  const std::uint32_t wrong = monitors_(reading, measured, drivenBy(choice, scene, state), missedTicks, state.monitors);
  const bool ran = state.session.now == SessionState::running;
  state.session = next(state.session, reading.inputs, wrong);
  const bool runs = state.session.now == SessionState::running;
  if (state.session.now == SessionState::fault) {
    halt(state);
  } else if (ran && runs) {
    control_.follow(choice, measured, state.control);
  } else {
    settle(measured, state);
  }
  TickRecord record = recordOf(scene, reading, measured, state);
  record.missedTicks = missedTicks;
  if (runs) {
    TickState moved = state;
    TickRecord attempt = record;
    run(choice, scene, measured, moved, attempt);
    if (isFinite(moved, attempt.command)) {
      state = moved;
      record = attempt;
    } else {
      state.session = next(state.session, reading.inputs, kFaultNotFinite);
      halt(state);
    }
  }
  record.state = state.session.now;
  record.faults = state.session.faults;
  return record;
}

}  // namespace haptiv
