#pragma once

#include "haptics/contact/ContactSet.h"
#include "haptics/control/Admittance.h"
#include "haptics/measuring/Measured.h"
#include "haptics/passivity/PassivityController.h"
#include "haptics/passivity/PassivityObserver.h"

namespace haptiv {

/// What passivity keeps from tick to tick.
struct PassivityState {
  PassivityObserver observer;
  bool controlled = false;  ///< in the tick before
};

/// What the scene does to the ball.
struct FeltScene {
  const ContactSet& contacts;
  int zones = 0;  ///< that the ball is in
  Vector3 force;  ///< on the ball, in W [N]
};

/// Observer and controller between feeling the scene and moving: docs/passivity.md.
class Passivity {
 public:
  Passivity(const DeviceDescription& description, double period);

  /// Observes, and, where the choice says so, adds the damping that keeps the energy from falling below zero.
  ///
  /// @param ball  the virtual mass
  /// @return      its force is to be added to the scene's; zero where nothing is missing
  /// Realtime-safe: yes.  Thread: servo.
  AddedDamping operator()(const ControlChoice& choice, const HapticScene& scene, const Measured& measured,
                          const AdmittanceState& ball, const FeltScene& felt, PassivityState& state) const noexcept;

 private:
  double lightestMass(const Measured& measured) const noexcept;

  JointVector inertia_;
  double largestForce_;
  double period_;
};

}  // namespace haptiv
