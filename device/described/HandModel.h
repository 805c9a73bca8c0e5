#pragma once

namespace haptiv {

/// The simulated operator's arm and grip: HumanHand tells how they work together.
struct HandModel {
  double stiffness = 400;       ///< from where the hand wants to be to the handle, arm and grip together [N/m]
  double damping = 20;          ///< of the arm [N s/m]
  double peakForce = 170;       ///< [N], no arm pulls harder
  double bandwidth = 40;        ///< of the low-pass by which it follows its own intent [rad/s]
  double mass = 1.8;            ///< of hand and forearm as far as they move along [kg]
  double gripStiffness = 3000;  ///< between hand and handle [N/m]; more than stiffness
  double gripDamping = 90;      ///< [N s/m]
  double gripStrength = 250;    ///< [N], beyond it the hand slips off
  double turnStiffness = 3;     ///< by which it holds the handle's orientation [N m/rad]
  double turnDamping = 0.15;    ///< [N m s/rad]
  double peakTorque = 8;        ///< [N m]
};

}  // namespace haptiv
