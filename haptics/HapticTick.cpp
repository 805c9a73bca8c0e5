#include "haptics/HapticTick.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "device/redundancy/DriftCorrection.h"
#include "device/redundancy/JointLimiter.h"
#include "haptics/DeviceFrames.h"
#include "haptics/FreeMotion.h"
#include "haptics/Zones.h"

namespace haptiv {
namespace {

/// The sensor's count at the end of its range; the count itself ends at 16 bits.
std::int32_t lastCount(double range, double resolution) {
  constexpr double kLargest = std::numeric_limits<std::int16_t>::max();
  return static_cast<std::int32_t>(std::min(std::floor(range / resolution), kLargest));
}

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

}  // namespace

struct HapticTick::Measured {
  JointVector angles;
  Pose X_BT;
  Vector3 p_WT;
  Vector3 handForce;   ///< in W [N]
  Vector3 handTorque;  ///< in W [N m]
};

HapticTick::HapticTick(const DeviceDescription& description, double period)
    : description_(description), arm_(description), resolution_(description), period_(period) {
  const HandleSensor& sensor = description.sensor;
  const std::int32_t force = lastCount(sensor.forceRange, sensor.forceResolution);
  const std::int32_t torque = lastCount(sensor.torqueRange, sensor.torqueResolution);
  saturation_ = {force, force, force, torque, torque, torque};
}

HapticTick::Measured HapticTick::measure(const HapticScene& scene, const DeviceReading& reading) const noexcept {
  Measured measured;
  measured.angles = description_.jointAngles(reading);
  measured.X_BT = arm_.forward(measured.angles);
  measured.p_WT = placeInScene(scene.device, measured.X_BT.position);
  const Wrench wrench_T = description_.handleWrench(reading);
  const Vector3 force_B = measured.X_BT.rotation * wrench_T.force;
  const Vector3 torque_B = measured.X_BT.rotation * wrench_T.torque;
  measured.handForce = scene.device.rotation * force_B;
  measured.handTorque = scene.device.rotation * torque_B;
  return measured;
}

std::uint32_t HapticTick::faultsOf(const DeviceReading& reading, const Measured& measured,
                                   const TickState& state) const noexcept {
  std::uint32_t faults = kNoFault;
  if (!reading.connected) faults |= kFaultDisconnected;
  for (std::size_t i = 0; i < saturation_.size(); ++i) {
    if (std::abs(std::int32_t{reading.sensorCounts[i]}) >= saturation_[i]) faults |= kFaultSensorSaturated;
  }
  if (!measured.p_WT.allFinite() || !measured.handForce.allFinite()) faults |= kFaultNotFinite;
  const double error = (state.desiredAngles - measured.angles).cwiseAbs().maxCoeff();
  if (state.started && !(error <= description_.control.trackingErrorLimit)) faults |= kFaultTracking;
  return faults;
}

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
  const Vector3 force =
      measured.handForce + record.environmentForce + freeMotionForce(ball.velocity, state.contacts, scene.tool.damping);
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
  const Measured measured = measure(scene, reading);
  state.faults |= faultsOf(reading, measured, state);
  if (!state.started) {
    state.started = true;
    state.desiredAngles = measured.angles;
    state.heldRotation = measured.X_BT.rotation;
    state.admittance = {measured.p_WT, Vector3::Zero()};
  }
  TickRecord record;
  record.missedTicks = missedTicks;
  record.sceneVersion = scene.version;
  record.reading = reading;
  record.jointAngles = measured.angles;
  record.desiredAngles = state.desiredAngles;
  record.position = measured.p_WT;
  record.desiredPosition = state.admittance.position;
  record.desiredVelocity = state.admittance.velocity;
  record.handForce = measured.handForce;
  record.handTorque = measured.handTorque;
  state.session = state.faults == kNoFault ? SessionState::running : SessionState::fault;
  record.state = state.session;
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
