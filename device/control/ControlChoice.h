#pragma once

#include <cstdint>

namespace haptiv {

/// What the device shows of the scene                                                  [paper, section IV.A]
enum class DisplayMode : std::uint8_t {
  admittance,         ///< measured force -> motion of a virtual mass, which the arm follows (fig. 6)
  positionImpedance,  ///< the scene's force at the measured place against the measured force -> admittance -> motion
  impedance,          ///< the scene's force at the measured place -> joint torques, J^T f; for light devices
};

/// How the arm is made to follow the desired motion.
enum class JointController : std::uint8_t {
  pd,              ///< rates for velocity-controlled drives: desired rate plus a gain on the angle's error
  computedTorque,  ///< torques from the arm's rigid-body model
};

/// What becomes of the handle's orientation.
enum class OrientationMode : std::uint8_t {
  held,  ///< as it was at the start of the session
  free,  ///< turned by the hand against a rotational inertia and damping about the grip
};

/// How a session drives the arm.
struct ControlChoice {
  DisplayMode display = DisplayMode::admittance;
  JointController joints = JointController::pd;
  OrientationMode orientation = OrientationMode::held;
  bool passivity = false;  ///< time-domain passivity control at the tool
  bool operator==(const ControlChoice&) const = default;
};

}  // namespace haptiv
