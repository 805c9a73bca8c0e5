#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "device/control/ControlChoice.h"

namespace haptiv {

inline constexpr std::array kDisplayModes = {DisplayMode::admittance, DisplayMode::positionImpedance,
                                             DisplayMode::impedance};
inline constexpr std::array kJointControllers = {JointController::pd, JointController::computedTorque};
inline constexpr std::array kOrientationModes = {OrientationMode::held, OrientationMode::free};

/// The names by which users choose: "admittance", "position-impedance", "impedance"; "pd", "computed-torque"; "held",
/// "free".
std::string nameOf(DisplayMode mode);
std::string nameOf(JointController controller);
std::string nameOf(OrientationMode mode);
/// Nothing where there is none of this name.
std::optional<DisplayMode> displayModeNamed(std::string_view name);
std::optional<JointController> jointControllerNamed(std::string_view name);
std::optional<OrientationMode> orientationModeNamed(std::string_view name);

}  // namespace haptiv
