#pragma once

#include "device/described/DeviceDescription.h"
#include "device/kinematics/ArmKinematics.h"
#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// What the device's reading says of arm and hand, at the instant of the reading.
struct Measured {
  JointVector angles = JointVector::Zero();  ///< [rad]
  JointVector rates = JointVector::Zero();   ///< of the encoders, behind a low-pass [rad/s]
  ArmPose arm;                               ///< X_BT and J_BT at these angles
  Vector3 p_WT = Vector3::Zero();            ///< [m]
  Vector3 v_WT = Vector3::Zero();            ///< [m/s]
  Vector3 handForce = Vector3::Zero();       ///< of the hand on the ball, in W [N]
  Vector3 handTorque = Vector3::Zero();      ///< of the hand about the ball's centre, in W [N m]

  bool allFinite() const noexcept;
};

/// What measuring needs of the reading before: rates are differences of encoder counts.
struct MeasuringState {
  bool started = false;
  std::int64_t deviceTime = 0;  ///< [us]
  JointVector angles = JointVector::Zero();
  JointVector rates = JointVector::Zero();
};

/// From raw counts to what they mean; the only place that knows encoders and sensor.
class Measuring {
 public:
  Measuring(const DeviceDescription& description, double period);

  /// Rates are zero at first, and begin anew where the device is not connected. Their time is the device's, so that a
  /// reading that did not come makes no joint look fast: the same reading again leaves them as they are.
  /// Realtime-safe: yes.  Thread: servo.
  Measured operator()(const DevicePlacement& device, const DeviceReading& reading,
                      MeasuringState& state) const noexcept;

 private:
  void follow(const JointVector& angles, const DeviceReading& reading, MeasuringState& state) const noexcept;

  DeviceDescription description_;
  ArmKinematics arm_;
  double period_;
  double share_;  ///< of a new difference in the rates, one step of the low-pass over a period
};

}  // namespace haptiv
