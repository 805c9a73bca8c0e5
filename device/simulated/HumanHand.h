#pragma once

#include "device/DeviceDescription.h"
#include "device/simulated/Hand.h"
#include "device/types.h"

namespace haptiv {

/// The simulated operator's arm: pulls the handle to where the hand wants to be.
///
///   f = k (x_h - x) + b (v_h - v), no stronger than peakForce
/// x_h, v_h: the target behind a critically damped low-pass of second order, so that a target that moves in steps, as
/// a mouse's does, makes no spikes. A hand that takes hold starts at the handle's place and speed.
class HumanHand {
 public:
  explicit HumanHand(const HandModel& model) : model_(model) {}

  /// Force on the handle after `dt` [s], in the frame of target and handle [N].
  /// Realtime-safe: yes.
  Vector3 pull(const HandTarget& target, const Vector3& position, const Vector3& velocity, double dt) noexcept;

 private:
  void follow(const Vector3& target, double dt) noexcept;

  HandModel model_;
  bool holding_ = false;
  Vector3 position_ = Vector3::Zero();
  Vector3 velocity_ = Vector3::Zero();
};

}  // namespace haptiv
