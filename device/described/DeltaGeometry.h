#pragma once

#include "device/types.h"

namespace haptiv {

/// A parallel arm of three legs that moves its handle along x, y and z and never turns it, as data. Letters in
/// brackets: R. E. Stamper, A three degree of freedom parallel manipulator with only translational degrees of freedom,
/// 1997.
///
/// Each leg has a frame of its own: u points away from B's z axis at legAngle, w along B's z, v = w x u. A motor in the
/// base turns the upper arm in the plane of u and w. The forearm is a parallelogram, hinged at both ends.
struct DeltaGeometry {
  static constexpr int kLegs = 3;

  double baseRadius = 0.04;         ///< of the motors' axes, along u [r, m]
  double baseOffset = -0.02309;     ///< of the leg's plane, along v [s, m]
  double upperArm = 0.06;           ///< [a, m]
  double forearm = 0.1025;          ///< the parallelogram's long side [b, m]
  double hinges = 0.0225;           ///< its hinges' offsets, both ends together [d + e, m]
  double platformRadius = 0.01443;  ///< from the forearm's end to the handle, along -u [c, m]
  Vector3 legAngles{1.8325957145940461, -0.2617993877991494, -2.356194490192345};  ///< of u, about B's z [rad]
};

/// How a Novint Falcon's counters and motors are wired; none of it is documented by its maker.
struct FalconWiring {
  double homedAngle = 0.6108652381980153;  ///< of each upper arm where a homed counter is zero [rad]
  double torqueCounts = 20480;             ///< motor value per torque at the leg [1/(N m)]
  double mostTorqueCounts = 4096;          ///< largest motor value that is ever sent
};

}  // namespace haptiv
