#pragma once

#include <cstdint>

namespace haptiv {

/// What an arm is held against: Table II of the paper, and how far from a singularity it is to stay.
struct Specification {
  double diameter = 1.7;             ///< of the workspace, a cylinder about the axis of joint 1, in the middle of B [m]
  double height = 0.6;               ///< [m]
  double force = 170;                ///< in any direction [N]
  double pitchYawTorque = 13;        ///< about any axis across the tool's x [N m]
  double rollTorque = 4.8;           ///< about the tool's x [N m]
  double speed = 1;                  ///< in any direction, the tool's orientation held [m/s]
  double payload = 7;                ///< at the tool; its weight, along -z of B, is carried in all poses [kg]
  double placeError = 1e-3;          ///< between where the tool is sent and where it is [m]
  double turnError = 2e-3;           ///< [rad]
  double smallestTranslation = 0.1;  ///< singular value of J's upper half [m]: 1 m/s would take 10 rad/s
  double smallestRotation = 0.1;     ///< of its lower half [1]: 1 rad/s would take 10 rad/s
};

}  // namespace haptiv
