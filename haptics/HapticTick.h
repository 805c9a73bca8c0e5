#pragma once

#include <cstdint>

#include "device/DeviceDescription.h"
#include "device/kinematics/ArmKinematics.h"
#include "device/redundancy/RedundancyResolution.h"
#include "haptics/Admittance.h"
#include "haptics/HapticScene.h"
#include "haptics/IfThenRenderer.h"
#include "haptics/Measured.h"
#include "haptics/ResolutionBlend.h"
#include "haptics/SceneFade.h"
#include "haptics/TickRecord.h"
#include "haptics/passivity/Passivity.h"
#include "haptics/safety/Monitors.h"

namespace haptiv {

/// All that one tick leaves for the next.
struct TickState {
  bool started = false;
  MeasuringState measuring;
  AdmittanceState admittance;
  Matrix3 heldRotation = Matrix3::Identity();  ///< R_BT at the start, held ever after
  JointVector desiredAngles = JointVector::Zero();
  ContactSet contacts;
  SceneFade fade;
  ResolutionBlend resolution;
  PassivityState passivity;
  SessionState session = SessionState::idle;
  std::uint32_t faults = kNoFault;
};

/// One tick: reading in, command and record out. No thread, no clock, no allocation: the same inputs give the same
/// bits, whether the device is simulated, on USB, or a log.
///
/// The path: joint angles and wrench -> contacts and zones at the admittance's position (29) -> admittance ->
/// redundancy resolution (3)-(5), (24), (25) with drift correction -> joint limiter -> joint controller -> safety.
/// The virtual mass is inside the control loop (fig. 9): walls act on its motion, which the arm then follows.
///
/// All of a record belongs to the instant of its reading; desiredAngles and desiredPosition too: they are what the
/// joint controller compares the measured ones with. After a fault the record holds what is measured, and no scene
/// force.
class HapticTick {
 public:
  HapticTick(const DeviceDescription& description, double period);

  /// Realtime-safe: yes.  Thread: servo.  Errors: none; faults latch in the state and brake the arm.
  /// @param missedTicks  grid points that the servo has skipped so far; they may be a fault
  TickRecord operator()(const HapticScene& scene, const DeviceReading& reading, TickState& state,
                        std::uint32_t missedTicks = 0) const noexcept;

 private:
  /// The scene's force on the ball, into the record.
  void feel(const HapticScene& scene, TickState& state, TickRecord& record) const noexcept;
  /// Admittance, redundancy resolution, limiter and joint controller: the state goes one period on.
  void move(const HapticScene& scene, const Measured& measured, TickState& state, TickRecord& record) const noexcept;

  DeviceDescription description_;
  double period_;
  Measuring measure_;
  Monitors monitors_;
  Passivity passivity_;
  ArmKinematics arm_;
  RedundancyResolution resolution_;
};

}  // namespace haptiv
