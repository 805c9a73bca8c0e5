#pragma once

#include "device/control/ControlChoice.h"

namespace haptiv {

/// How the host drives the joints.
struct ControlSettings {
  ControlChoice choice;                ///< where the operator has not chosen
  double driftGain = 50;               ///< closed-loop correction of the inverse kinematics [1/s]
  double jointGain = 60;               ///< joint controller: rate per position error [1/s]
  double singularityDamping = 0.05;    ///< largest damping mu of the pseudoinverse
  double singularityThreshold = 0.01;  ///< manipulability [m^3] below which damping sets in
  double trackingErrorLimit = 0.05;    ///< [rad] between desired and measured joint angle; beyond: fault
  double trackingFrequency = 120;      ///< natural frequency of that error under computed torque [rad/s]
  double trackingDampingRatio = 1;     ///< of the same
  double velocityBandwidth = 1000;     ///< of the low-pass behind the differences of encoder angles [rad/s]
  double rotationalInertia = 0.02;     ///< of a handle that turns freely, about the grip [kg m^2]
  double rotationalDamping = 0.1;      ///< of the same [N m s/rad]
  double orientationStiffness = 20;    ///< of the spring that holds the handle in impedance display [N m/rad]
  double orientationDamping = 0.5;     ///< of the same [N m s/rad]
  double selfMotionDamping = 10;       ///< in impedance display, per inertia of the rotors [1/s]
};

}  // namespace haptiv
