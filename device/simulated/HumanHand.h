#pragma once

#include "device/described/DeviceDescription.h"
#include "device/simulated/Hand.h"
#include "device/types.h"

namespace haptiv {

/// The simulated operator: an arm that draws the hand to where it wants to be, and a grip that holds the handle.
///
///   m u' = f_arm - f_grip
///   f_arm  = k_arm (x_e - h) + b (v_e - u), no stronger than peakForce: where it wants to be, hand
///   f_grip = k_grip (h - x) + b_grip (u - v): hand, handle; no stronger than gripStrength
///   torque = k_turn (turn from handle to wanted orientation) - b_turn w, no stronger than peakTorque
/// k_arm is such that arm and grip in series have the description's stiffness: a hand at rest pulls with that.
/// x_e, v_e: the target behind a critically damped low-pass of second order, so that a target that moves in steps, as
/// a mouse's does, makes no spikes; the wanted orientation follows likewise, by a low-pass of first order. A hand that
/// takes hold starts at the handle's place and speed.
///
/// Beyond its strength the grip slips along the handle; after kLongestSlip the hand has lost it, and takes hold anew
/// only when the operator has let go and wants to hold again.
class HumanHand {
 public:
  static constexpr double kLongestSlip = 0.04;  ///< [m]

  explicit HumanHand(const HandModel& model);

  /// Wrench on the handle after dt [s], all in the same frame. Realtime-safe: yes.
  Wrench pull(const HandTarget& target, const Pose& handle, const Twist& motion, double dt) noexcept;

 private:
  void takeHold(const Pose& handle, const Twist& motion) noexcept;
  /// Position and velocity of the place where the hand wants to be go towards the target.
  void follow(const Vector3& target, double dt) noexcept;
  Vector3 grip(const Vector3& handle, const Vector3& velocity) noexcept;
  Vector3 turn(const HandTarget& target, const Pose& handle, const Vector3& spin, double dt) noexcept;

  HandModel model_;
  double armStiffness_;
  bool holding_ = false;
  bool lost_ = false;
  Vector3 wanted_ = Vector3::Zero(), wantedVelocity_ = Vector3::Zero();  // x_e, v_e
  Vector3 hand_ = Vector3::Zero(), handVelocity_ = Vector3::Zero();      // h, u
  Vector3 slip_ = Vector3::Zero();                                       // of the hand along the handle [m]
  Matrix3 held_ = Matrix3::Identity();                                   // orientation when it took hold
  Matrix3 wantedRotation_ = Matrix3::Identity();
};

}  // namespace haptiv
