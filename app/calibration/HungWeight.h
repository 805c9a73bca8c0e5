#pragma once

#include <span>

#include "device/described/DeviceDescription.h"
#include "device/types.h"

namespace haptiv {

inline constexpr double kStandardGravity = 9.80665;  ///< [m/s^2]; places on earth differ by up to 0.3 %

/// A weight that hangs on the handle, the arm standing in some pose.
struct HungWeight {
  double mass = 0;                   ///< [kg]
  Vector3 down = -Vector3::UnitZ();  ///< where gravity pulls, a unit vector in T
  Vector3 place = Vector3::Zero();   ///< of its hook, from the tool, in T [m]
};

/// Its force and torque on the handle, in T [N], [N m]: f = m g down, t = place x f.
Vector6 loadOf(const HungWeight& weight);

/// Throws CalibrationRefused, what and what to do, where a sensor's matrix cannot be found by these loads, in T [N],
/// [N m], however well they are measured: too few, a number that is none, one beyond the sensor's range, an axis that
/// none of them tells. Returns their condition, how well they tell the axes apart; 1 is best.
double expectTelling(std::span<const Vector6> loads, const HandleSensor& sensor);

}  // namespace haptiv
