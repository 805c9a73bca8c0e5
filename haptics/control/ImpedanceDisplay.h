#pragma once

#include <optional>

#include "device/described/DeviceDescription.h"
#include "device/dynamics/ArmDynamics.h"
#include "haptics/measuring/Measured.h"

namespace haptiv {

/// Impedance display: motion is measured and force is commanded, without a force sensor         [paper, section IV.A]
///
///   tau = J^T w + g(q) - N D N qd
/// w: the wrench that the hand is to feel; g: the arm's weight, where its description tells the links' bodies; N: the
/// projector on the null space of J, D = selfMotionDamping times the rotors' inertia: self-motion, which no wrench
/// at the tool holds, comes to rest. The hand feels the arm's own inertia and friction too: for light devices.
class ImpedanceDisplay {
 public:
  explicit ImpedanceDisplay(const DeviceDescription& description);

  /// Torques of the drives [N m], unlimited.
  /// @param onTool  w, in B [N, N m]
  /// Realtime-safe: yes.
  JointVector operator()(const Measured& measured, const Wrench& onTool) const noexcept;

  /// The torsional spring and damper that hold the handle at R_BT, in B [N m]:
  /// orientationStiffness times the rotation vector back to `held`, less orientationDamping times the handle's rate.
  /// Realtime-safe: yes.
  Vector3 holding(const Matrix3& held, const Measured& measured) const noexcept;
  /// The torque of a handle that turns freely: rotationalDamping alone, in B [N m]. Realtime-safe: yes.
  Vector3 loose(const Measured& measured) const noexcept;

 private:
  ControlSettings control_;
  JointVector selfMotionDamping_;  ///< D [N m s/rad]
  std::optional<ArmDynamics> dynamics_;
};

}  // namespace haptiv
