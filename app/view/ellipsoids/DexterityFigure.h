#pragma once

#include <array>

#include "app/view/ellipsoids/ManipulabilityEllipsoid.h"
#include "device/kinematics/ArmKinematics.h"
#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// Of which 3x10 block of the Jacobian: rows 0..2, or rows 3..5.
enum class Manipulability { translational, rotational };

/// The manipulability ellipsoids at the wrist: the tool's velocities that joint rates of norm 1 rad/s give, all joints
/// weighing the same; half axes u_i s_i of either block of the Jacobian  [paper, eqs. (9), (10)]
///
/// Their length in the picture grows with the scale at which the device stands in the scene, as the arm's does. Both
/// are hidden at first; what is hidden costs nothing. Thread: GUI.
class DexterityFigure {
 public:
  static constexpr double kMetresPerSpeed = 0.1;     ///< drawn: [m] per [m/s]
  static constexpr double kMetresPerTurning = 0.03;  ///< drawn: [m] per [rad/s]
  /// Yellow and violet: told apart by colour-blind eyes too, and unlike walls, zones and forces.
  static SbColor colorOf(Manipulability which);

  DexterityFigure();

  SoSeparator* root() const { return root_.get(); }
  void setUp(const DevicePlacement& placement, const DeviceDescription& description);
  /// @param p_WT  the tool's place [m]   @param q  joint angles [rad]
  void show(const Vector3& p_WT, const JointVector& q);
  void setVisible(Manipulability which, bool visible);

 private:
  void draw();
  ManipulabilityEllipsoid& of(Manipulability which) { return ellipsoids_[static_cast<std::size_t>(which)]; }

  NodeRef<SoSeparator> root_;
  std::array<ManipulabilityEllipsoid, 2> ellipsoids_;
  ArmKinematics kinematics_{DeviceDescription{}};
  DevicePlacement placement_;
  Vector3 p_WT_ = Vector3::Zero();
  JointVector q_ = JointVector::Zero();
};

}  // namespace haptiv
