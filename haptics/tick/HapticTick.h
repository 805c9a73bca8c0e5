#pragma once

#include <cstdint>

#include "device/Nonblocking.h"
#include "device/described/DeviceDescription.h"
#include "haptics/control/ArmControl.h"
#include "haptics/laws/IfThenRenderer.h"
#include "haptics/measuring/Measured.h"
#include "haptics/passivity/Passivity.h"
#include "haptics/safety/Clamps.h"
#include "haptics/safety/Monitors.h"
#include "haptics/safety/SessionStates.h"
#include "haptics/scene/HapticScene.h"
#include "haptics/scene/SceneFade.h"
#include "haptics/tick/TickRecord.h"

namespace haptiv {

/// All that one tick leaves for the next.
struct TickState {
  SessionStates session;
  MeasuringState measuring;
  MonitorState monitors;
  ControlState control;
  ContactSet contacts;
  SceneFade fade;
  PassivityState passivity;
  std::uint32_t clamps = kNoClamp;  ///< that held something back in the tick before
};

/// One tick: reading in, command and record out. No thread, no clock, no allocation: the same inputs give the same
/// bits, whether the device is simulated, on USB, or a log.
///
/// The path: joint angles and wrench -> monitors -> session state -> contacts and zones -> control -> clamps ->
/// set-points of the drives; docs/control.md. Under admittance control the virtual mass is inside the control loop
/// (fig. 9): walls act on its motion, which the arm then follows.
///
/// All of a record belongs to the instant of its reading; desiredAngles and desiredPosition too: they are what the
/// joint controller compares the measured ones with. Where the session is not running the arm brakes, and the record
/// holds what is measured and no scene force. Running begins anew each time: at rest, where the arm is then, and with
/// the scene's force fading in.
class HapticTick {
 public:
  HapticTick(const DeviceDescription& description, double period);

  /// Realtime-safe: yes.  Thread: servo.  Errors: none; faults latch in the state and brake the arm.
  /// @param missedTicks  grid points that the servo has skipped so far; they may be a fault
  TickRecord operator()(const HapticScene& scene, const DeviceReading& reading, TickState& state,
                        std::uint32_t missedTicks = 0) const noexcept HAPTIV_NONBLOCKING;

 private:
  /// The virtual mass at rest where the arm is; whatever is touched there is touched anew, and fades in.
  void settle(const Measured& measured, TickState& state) const noexcept;
  /// Feels the scene and moves on by one period.
  void run(const ControlChoice& choice, const HapticScene& scene, const Measured& measured, TickState& state,
           TickRecord& record) const noexcept;
  /// The scene's force on the ball, into the record.
  void feel(const HapticScene& scene, const ToolMotion& tool, TickState& state, TickRecord& record) const noexcept;

  double period_;
  Measuring measure_;
  Monitors monitors_;
  Clamps clamps_;
  Passivity passivity_;
  ArmControl control_;
};

}  // namespace haptiv
