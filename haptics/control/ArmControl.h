#pragma once

#include <optional>

#include "haptics/control/ComputedTorque.h"
#include "haptics/control/ControlState.h"
#include "haptics/control/ImpedanceDisplay.h"
#include "haptics/control/InverseKinematics.h"
#include "haptics/laws/IfThenRenderer.h"
#include "haptics/measuring/Measured.h"
#include "haptics/safety/Clamps.h"

namespace haptiv {

/// From the hand's force and the scene's to the drives' set-points, in the way that is chosen; docs/control.md draws
/// each of them.
///
///   admittance          the scene is felt at the virtual mass; M v' = f_hand + f_scene (29) moves it, the arm follows
///   positionImpedance   the scene is felt where the arm is; the rest of f_hand + f_scene goes through M v' + B v
///   impedance           the scene is felt where the arm is, and its force goes to the joints as torques
/// All but the constructor: realtime-safe.  Thread: servo.
class ArmControl {
 public:
  ArmControl(const DeviceDescription& description, double period);

  /// What is in force: the scene's choice, or else the description's. An arm without bodies cannot do computed torque:
  /// PD serves. A device of the impedance type can do impedance display alone.
  ControlChoice choiceFor(const HapticScene& scene) const noexcept;

  /// The motion that is desired is rest where the arm is.
  void begin(const Measured& measured, ControlState& state) const noexcept;
  /// Where the hand alone leads the arm, the motion that is desired is the one that is measured.
  void follow(const ControlChoice& choice, const Measured& measured, ControlState& state) const noexcept;

  /// The ball as the scene's laws are to see it.
  ToolMotion felt(const ControlChoice& choice, const HapticScene& scene, const Measured& measured,
                  const ControlState& state) const noexcept;

  /// Set-points for the coming period, within the clamps; the state goes one period on.
  /// @param sceneForce  of the scene on the ball as it is felt, in W [N]
  /// @param contacts    of that ball: they say in which directions it is free, eq. (28)
  /// @param clamps      gets the bits of what was held back
  DeviceCommand operator()(const ControlChoice& choice, const HapticScene& scene, const Measured& measured,
                           const Vector3& sceneForce, const ContactSet& contacts, ControlState& state,
                           std::uint32_t& clamps) const noexcept;

 private:
  Vector3 ballVelocity(const ControlChoice& choice, const HapticScene& scene, const Vector3& force,
                       const ContactSet& contacts, const AdmittanceState& ball) const noexcept;
  Vector3 handleRate(const ControlChoice& choice, const Vector3& torque_B, const RotationState& handle) const noexcept;
  DeviceCommand joints(JointController controller, const JointMotion& desired, const Measured& measured,
                       const Wrench& hand_B) const noexcept;
  DeviceCommand display(const ControlChoice& choice, const HapticScene& scene, const Measured& measured,
                        const Vector3& force, const ControlState& state, std::uint32_t& clamps) const noexcept;

  ControlSettings settings_;
  DeviceType type_;
  ResolutionChoice resolution_;
  double period_;
  Clamps clamps_;
  InverseKinematics kinematics_;
  ImpedanceDisplay display_;
  std::optional<ComputedTorque> computedTorque_;
};

}  // namespace haptiv
