#pragma once

#include <memory>

#include "device/DeviceDescription.h"
#include "device/Vishard10.h"
#include "haptics/Admittance.h"
#include "haptics/HapticScene.h"
#include "haptics/IfThenRenderer.h"
#include "haptics/TickRecord.h"

namespace haptiv {

/// All that one tick leaves for the next.
struct TickState {
  bool started = false;
  AdmittanceState admittance;
  Matrix3 heldRotation = Matrix3::Identity();     ///< R_BT at the start, held ever after
  JointVector desiredAngles = JointVector::Zero();
  ContactSet contacts;
  std::uint32_t sceneVersion = 0;
  Vector3 sceneForce = Vector3::Zero();           ///< of the tick before, as felt
  Vector3 bump = Vector3::Zero();                 ///< force that an edit would have stepped by ...
  double bumpLeft = 0;                            ///< ... and how much of it is still withheld, 1 to 0
  std::uint32_t faults = kNoFault;
};

/// One tick: reading in, command and record out. No thread, no clock, no allocation: the same inputs give the same
/// bits, whether the device is simulated, on USB, or a log.
///
/// The path: joint angles and wrench -> contacts and zones at the admittance's position (29) -> admittance ->
/// redundancy resolution (3) with drift correction -> joint limiter -> safety -> joint controller.
class HapticTick {
 public:
  HapticTick(const DeviceDescription& description, double period);

  /// Realtime-safe: yes.  Thread: servo.  Errors: none; faults latch in the state and brake the arm.
  TickRecord operator()(const HapticScene& scene, const DeviceReading& reading, TickState& state) const noexcept;

 private:
  DeviceDescription description_;
  Vishard10 arm_;
  double period_;
};

}  // namespace haptiv
