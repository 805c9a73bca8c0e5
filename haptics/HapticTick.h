#pragma once

#include <cstdint>

#include "device/DeviceDescription.h"
#include "haptics/HapticScene.h"
#include "haptics/IfThenRenderer.h"
#include "haptics/Measured.h"
#include "haptics/SceneFade.h"
#include "haptics/TickRecord.h"
#include "haptics/control/ArmControl.h"
#include "haptics/passivity/Passivity.h"
#include "haptics/safety/Monitors.h"

namespace haptiv {

/// All that one tick leaves for the next.
struct TickState {
  bool started = false;
  MeasuringState measuring;
  ControlState control;
  ContactSet contacts;
  SceneFade fade;
  PassivityState passivity;
  SessionState session = SessionState::idle;
  std::uint32_t faults = kNoFault;
};

/// One tick: reading in, command and record out. No thread, no clock, no allocation: the same inputs give the same
/// bits, whether the device is simulated, on USB, or a log.
///
/// The path: joint angles and wrench -> contacts and zones -> control -> set-points of the drives; docs/control.md.
/// Under admittance control the virtual mass is inside the control loop (fig. 9): walls act on its motion, which the
/// arm then follows.
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
  void feel(const HapticScene& scene, const ToolMotion& tool, TickState& state, TickRecord& record) const noexcept;

  double period_;
  Measuring measure_;
  Monitors monitors_;
  Passivity passivity_;
  ArmControl control_;
};

}  // namespace haptiv
