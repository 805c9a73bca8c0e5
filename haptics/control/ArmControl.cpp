#include "haptics/control/ArmControl.h"

#include "haptics/laws/FreeMotion.h"
#include "haptics/scene/DeviceFrames.h"

namespace haptiv {
ArmControl::ArmControl(const DeviceDescription& description, double period)
    : settings_(description.control),
      type_(description.type),
      resolution_(description.redundancy.choice),
      period_(period),
      clamps_(description, period),
      kinematics_(description, period),
      display_(description) {
  if (!description.bodies.links.empty()) computedTorque_.emplace(description);
}

ControlChoice ArmControl::choiceFor(const HapticScene& scene) const noexcept {
  ControlChoice choice = scene.control.value_or(settings_.choice);
  if (!computedTorque_) choice.joints = JointController::pd;
  if (type_ == DeviceType::impedance) choice.display = DisplayMode::impedance;
  return choice;
}

void ArmControl::begin(const Measured& measured, ControlState& state) const noexcept {
  state.admittance = {measured.p_WT, Vector3::Zero()};
  state.handle = {measured.arm.X_BT.rotation, Vector3::Zero()};
  state.desiredAngles = measured.angles;
  state.desiredRates.setZero();
}

void ArmControl::follow(const ControlChoice& choice, const Measured& measured, ControlState& state) const noexcept {
  if (choice.display != DisplayMode::impedance) return;
  state.admittance = {measured.p_WT, measured.v_WT};
  state.desiredAngles = measured.angles;
  state.desiredRates = measured.rates;
  if (choice.orientation == OrientationMode::free)
    state.handle = {measured.arm.X_BT.rotation, measured.arm.J_BT.bottomRows<3>() * measured.rates};
}

ToolMotion ArmControl::felt(const ControlChoice& choice, const HapticScene& scene, const Measured& measured,
                            const ControlState& state) const noexcept {
  if (choice.display == DisplayMode::admittance)
    return {state.admittance.position, state.admittance.velocity, scene.tool.radius};
  return {measured.p_WT, measured.v_WT, scene.tool.radius};
}

Vector3 ArmControl::ballVelocity(const ControlChoice& choice, const HapticScene& scene, const Vector3& force,
                                 const ContactSet& contacts, const AdmittanceState& ball) const noexcept {
  const double damping = scene.tool.damping;
  const Vector3 slowing = choice.display == DisplayMode::admittance ? freeMotionForce(ball.velocity, contacts, damping)
                                                                    : Vector3(-damping * ball.velocity);
  return nextVelocity(ball, force + slowing, scene.tool.mass, period_);
}

Vector3 ArmControl::handleRate(const ControlChoice& choice, const Vector3& torque_B,
                               const RotationState& handle) const noexcept {
  if (choice.orientation == OrientationMode::held) return Vector3::Zero();
  return nextRate(handle, torque_B, settings_.rotationalInertia, settings_.rotationalDamping, period_);
}

DeviceCommand ArmControl::joints(JointController controller, const JointMotion& desired, const Measured& measured,
                                 const Wrench& hand_B) const noexcept {
  DeviceCommand command;
  command.enabled = true;
  if (controller == JointController::computedTorque && computedTorque_) {
    command.mode = DriveMode::torque;
    command.jointTorques = (*computedTorque_)(desired, measured, hand_B);
  } else {
    const JointVector error = desired.angles - measured.angles;
    command.jointRates = desired.rates + settings_.jointGain * error;
  }
  return command;
}

DeviceCommand ArmControl::display(const ControlChoice& choice, const HapticScene& scene, const Measured& measured,
                                  const Vector3& force, const ControlState& state,
                                  std::uint32_t& clamps) const noexcept {
  Wrench onTool_B;
  onTool_B.force = scene.device.rotation.transpose() * clamps_.force(force, clamps);
  const Vector3 torque = choice.orientation == OrientationMode::free
                             ? display_.loose(measured)
                             : display_.holding(state.handle.rotation, measured);
  onTool_B.torque = clamps_.torque(torque, clamps);
  DeviceCommand command;
  command.enabled = true;
  command.mode = DriveMode::torque;
  command.jointTorques = display_(measured, onTool_B);
  clamps_.command(command, measured.arm.J_BT, clamps);
  return command;
}

DeviceCommand ArmControl::operator()(const ControlChoice& choice, const HapticScene& scene, const Measured& measured,
                                     const Vector3& sceneForce, const ContactSet& contacts, ControlState& state,
                                     std::uint32_t& clamps) const noexcept {
  const DevicePlacement& device = scene.device;
  if (choice.display == DisplayMode::impedance) {
    const Vector3 slowing = freeMotionForce(measured.v_WT, contacts, scene.tool.damping);
    return display(choice, scene, measured, sceneForce + slowing, state, clamps);
  }
  const Matrix3 R_BW = device.rotation.transpose();
  const Wrench hand_B{R_BW * measured.handForce, R_BW * measured.handTorque};
  const Vector3 wantedVelocity =
      ballVelocity(choice, scene, measured.handForce + sceneForce, contacts, state.admittance);
  const Vector3 velocity = clamps_.velocity(state.admittance.velocity, wantedVelocity, device.scale, clamps);
  const Vector3 rate = handleRate(choice, hand_B.torque, state.handle);
  Vector6 twist_B;
  twist_B << R_BW * velocity / device.scale, rate;
  const Pose wanted{placeInBase(device, state.admittance.position), state.handle.rotation};
  const InverseKinematics::Motion motion = kinematics_(scene.resolution.value_or(resolution_), wanted, twist_B,
                                                       {state.desiredAngles, state.desiredRates}, state.resolution);
  const JointMotion desired{state.desiredAngles, motion.rates, (motion.rates - state.desiredRates) / period_};
  DeviceCommand command = joints(choice.joints, desired, measured, hand_B);
  clamps_.command(command, measured.arm.J_BT, clamps);
  if (motion.share < 1) clamps |= kClampJointRate;

  state.desiredAngles += period_ * motion.rates;
  state.desiredRates = motion.rates;
  state.admittance.velocity = device.scale * (device.rotation * motion.velocity);
  state.admittance.position += period_ * state.admittance.velocity - device.scale * (device.rotation * motion.heldBack);
  state.handle.rate = motion.share * rate;
  state.handle.rotation = turned(state.handle.rotation, state.handle.rate, period_);
  return command;
}

}  // namespace haptiv
