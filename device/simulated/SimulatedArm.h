#pragma once

#include <vector>

#include "device/Encoder.h"
#include "device/board/BoardSignals.h"
#include "device/dynamics/ArmDynamics.h"
#include "device/simulated/ForceTorqueSensor.h"
#include "device/simulated/Hand.h"
#include "device/simulated/HumanHand.h"
#include "device/simulated/plant/JointStep.h"

namespace haptiv {

/// The arm as it hangs there, with a hand at its handle: what the drives make of a demand, and what the wires to the
/// interface board say then. No board, no host.
///
/// Modelled: the links as rigid bodies with their weight, the rotors behind their gears, viscous and dry friction, the
/// motors' torque limits and velocity loops, motors that brake when they are bypassed, the operator's arm and grip,
/// noise, bandwidth and range of the sensor, the encoders' counts. Not modelled: play and elasticity of gears and
/// links, heat, and the mass of the handle beyond the sensor, which feels the hand alone. An arm whose description has
/// no bodies has links without mass: rotors alone, no weight. A device of the impedance type has no sensor.
class SimulatedArm {
 public:
  /// @param start  joint angles, finite [rad]
  SimulatedArm(const DeviceDescription& description, const JointVector& start, std::uint64_t seed);

  /// One step of dt, at most kLongestStep.
  /// @param deadMotors  bit i: that of joint i + 1 gives no torque, whatever the demand
  /// Realtime-safe: yes.
  void advance(const DriveDemand& demand, const HandTarget& target, double dt, unsigned deadMotors = 0) noexcept;
  static constexpr double kLongestStep = 0.125e-3;  ///< [s]

  /// Encoder and sensor counts, the latter with the noise of one more sample. Realtime-safe: yes.
  BoardInputs measure() noexcept;
  /// Encoder counts alone: without noise, as often as one likes. Realtime-safe: yes.
  std::array<std::int32_t, kJointCount> encoderCounts() const noexcept;

  const JointVector& angles() const noexcept { return angles_; }    ///< [rad]
  const JointVector& rates() const noexcept { return rates_; }      ///< [rad/s]
  const JointVector& torques() const noexcept { return torques_; }  ///< of the motors in the last step [N m]
  const Wrench& handWrench() const noexcept { return onTool_B_; }   ///< on the handle in the last step, in B

 private:
  TorqueLaw lawOf(int joint, const DriveDemand& demand, double weight) noexcept;

  ArmKinematics arm_;
  ArmDynamics dynamics_;
  std::vector<Encoder> encoders_;  // never grows after construction
  JointVector viscous_, coulomb_, brakeFriction_;
  std::vector<JointDrive> drives_;  // never grows after construction
  HumanHand hand_;
  ForceTorqueSensor sensor_;
  bool hasSensor_;  // false: its counts are zero
  JointVector angles_, rates_ = JointVector::Zero(), torques_ = JointVector::Zero();
  Wrench onTool_B_;
};

}  // namespace haptiv
