#pragma once

#include "device/types.h"

namespace haptiv {

/// The drives of all joints; each vector has one entry a joint.
struct JointDrives {
  JointVector gearRatio = JointVector::Constant(100);       ///< motor turns per joint turn
  JointVector countsPerTurn = JointVector::Constant(4096);  ///< encoder counts per motor turn
  JointVector rateLimit = JointVector::Constant(6.28);      ///< [rad/s]
  JointVector torqueLimit = JointVector::Constant(60);      ///< [N m]
  JointVector inertia = JointVector::Constant(1);           ///< of the rotors, behind their gears [kg m^2]
  JointVector bandwidth = JointVector::Constant(400);       ///< of the drive's velocity loop [rad/s]
  JointVector viscousFriction = JointVector::Zero();        ///< at the joint [N m s/rad]
  JointVector coulombFriction = JointVector::Zero();        ///< at the joint [N m]
  /// Of motors that are bypassed, at the joint [N m s/rad]; within torqueLimit.
  JointVector brakeDamping = JointVector::Constant(40);
  /// Dry friction more, at the joint, while the motors brake [N m]: it holds the arm's weight.
  JointVector brakeFriction = JointVector::Zero();

  /// Encoder counts per radian of the joint.
  JointVector countsPerRadian() const;
};

/// What the encoders' counts mean, found by `haptiv device home`; each vector has one entry a joint.
struct EncoderZero {
  JointVector zero = JointVector::Zero();       ///< counts at the joint's zero, whole numbers
  JointVector reference = JointVector::Zero();  ///< the pose into which the arm is set for homing [rad]
};

}  // namespace haptiv
