#pragma once

#include "device/types.h"

namespace haptiv {

/// When the safety circuit of the device stops the arm [paper, section III.D; docs/board.md], how far the host's clamps
/// let the session go, and when the host stops it. docs/safety.md tells each in words; `haptiv device check` holds the
/// clamps against the arm's specification.
struct SafetyThresholds {
  double watchdogTime = 0.01;  ///< longest time between two commands [s]
  /// A joint turns too fast when its encoder counts more than countThreshold within velocityTimeUnit [s].
  double velocityTimeUnit = 0.001;
  JointVector countThreshold = JointVector::Constant(512);
  double forceClamp = 170;         ///< largest force of the scene on the ball [N]
  double torqueClamp = 13;         ///< largest torque of the scene on the handle [N m]
  double speedClamp = 1.5;         ///< largest speed of the tool [m/s]
  double accelerationClamp = 100;  ///< by which the tool becomes faster, at most [m/s^2]
  double handForceLimit = 300;     ///< more than any hand can [N]; beyond: fault
  double oscillationSpeed = 0.1;   ///< amplitude of fast swings that do not die down [m/s]; beyond: fault
  double missedTime = 0.5;         ///< that the servo may miss within a second [s]; beyond: fault
};

}  // namespace haptiv
