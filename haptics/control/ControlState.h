#pragma once

#include "haptics/control/Admittance.h"
#include "haptics/control/ResolutionBlend.h"
#include "haptics/control/RotationalAdmittance.h"

namespace haptiv {

/// What control leaves for the next tick: the motion that the arm is to make.
struct ControlState {
  AdmittanceState admittance;                       ///< the virtual mass
  RotationState handle;                             ///< the orientation that goes with it
  JointVector desiredAngles = JointVector::Zero();  ///< where the joints are to be [rad]
  JointVector desiredRates = JointVector::Zero();   ///< of the tick before [rad/s]
  ResolutionBlend resolution;

  bool allFinite() const noexcept {
    return admittance.position.allFinite() && admittance.velocity.allFinite() && handle.rotation.allFinite() &&
           handle.rate.allFinite() && desiredAngles.allFinite() && desiredRates.allFinite();
  }
};

}  // namespace haptiv
