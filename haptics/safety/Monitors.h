#pragma once

#include "haptics/safety/EncoderMonitor.h"
#include "haptics/safety/MissedTickBudget.h"
#include "haptics/safety/OscillationMonitor.h"
#include "haptics/safety/RunawayMonitor.h"
#include "haptics/safety/SensorMonitor.h"
#include "haptics/safety/ToolSpeedMonitor.h"

namespace haptiv {

/// How the arm was driven up to this tick.
struct Driven {
  bool running = false;       ///< the scene is felt
  bool isLed = false;         ///< and the arm is sent to where it is desired, not merely pushed
  JointVector desiredAngles;  ///< that the joint controller was given [rad]
  Swinging swinging;          ///< what of it the hand feels
  std::uint32_t clamps = 0;   ///< Clamp bits of the tick before
};

/// What the monitors remember from tick to tick.
struct MonitorState {
  SensorState sensor;
  EncoderState encoders;
  MissedTickState missed;
  OscillationState oscillation;
  double runaway = 0;  ///< for how long the virtual mass has run by itself [s]
};

/// All that looks at a tick's inputs and finds what a session must not go on with, before anything is computed of it.
class Monitors {
 public:
  Monitors(const DeviceDescription& description, double period);

  /// @param missedTicks  grid points that the servo has skipped so far
  /// @return             Fault bits of this tick, not latched
  /// Realtime-safe: yes.  Thread: servo.
  std::uint32_t operator()(const DeviceReading& reading, const Measured& measured, const Driven& driven,
                           std::uint32_t missedTicks, MonitorState& state) const noexcept;

 private:
  std::uint32_t motion(const Measured& measured, const Driven& driven, MonitorState& state) const noexcept;

  SensorMonitor sensor_;
  EncoderMonitor encoders_;
  MissedTickBudget missed_;
  OscillationMonitor oscillation_;
  RunawayMonitor runaway_;
  ToolSpeedMonitor toolSpeed_;
  double trackingErrorLimit_;
};

}  // namespace haptiv
