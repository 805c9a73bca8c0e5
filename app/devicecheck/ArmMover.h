#pragma once

#include <functional>

#include "device/described/DeviceDescription.h"
#include "device/kinematics/ArmKinematics.h"
#include "device/redundancy/RedundancyResolution.h"

namespace haptiv {

/// Moves the tool along straight lines and about axes as a session's tick does: redundancy resolution with drift
/// correction at 1 kHz, and the joint limiter, which slows the whole motion down.
class ArmMover {
 public:
  /// After each tick: the arm's pose, and what it was to be.
  using Visit = std::function<void(const JointVector& q, const ArmPose& actual, const Pose& wanted)>;

  ArmMover(const DeviceDescription& device, const ArmKinematics& arm, const RedundancyResolution& resolution,
           const ResolutionChoice& choice);

  /// At the description's home angles.
  void goHome();
  const Pose& wanted() const { return wanted_; }

  /// At 1 m/s, the orientation held. False where the arm did not get on: it is where it stopped then.
  bool moveTo(const Vector3& p_BT, const Visit& visit);
  /// One full turn at pi rad/s about an axis of B through the tool.
  bool turnAbout(const Vector3& axis, const Visit& visit);

 private:
  /// Holds the twist for this long, longer where the limiter slows.
  bool move(const Vector6& twist, double seconds, const Visit& visit);

  const DeviceDescription* device_;
  const ArmKinematics* arm_;
  const RedundancyResolution* resolution_;
  ResolutionChoice choice_;
  JointVector q_ = JointVector::Zero();
  ArmPose actual_;
  Pose wanted_;
};

}  // namespace haptiv
