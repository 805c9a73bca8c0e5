#pragma once

#include "haptics/contact/ContactSet.h"
#include "haptics/control/Admittance.h"
#include "haptics/passivity/PassivityObserver.h"
#include "haptics/measuring/Measured.h"
#include "haptics/tick/TickRecord.h"

namespace haptiv {

/// What passivity keeps from tick to tick.
struct PassivityState {
  PassivityObserver observer;
  bool controlled = false;  ///< in the tick before
};

/// Observer and controller between feeling the scene and moving: docs/passivity.md.
class Passivity {
 public:
  Passivity(const DeviceDescription& description, double period);

  /// Observes, and, where the choice says so, adds the damping that keeps the energy from falling below zero.
  ///
  /// @param ball      the virtual mass
  /// @param contacts  what it touches
  /// @param record  in: the scene's force, what it touches, and the hand's force; out: energy and added damping
  /// @return        force to be added to the scene's, in W [N]; zero where nothing is missing
  /// Realtime-safe: yes.  Thread: servo.
  Vector3 operator()(const ControlChoice& choice, const HapticScene& scene, const Measured& measured,
                     const AdmittanceState& ball, const ContactSet& contacts, PassivityState& state,
                     TickRecord& record) const noexcept;

 private:
  double lightestMass(const Measured& measured) const noexcept;

  JointVector inertia_;
  double largestForce_;
  double period_;
};

}  // namespace haptiv
