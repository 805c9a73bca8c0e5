#include "device/control/ControlNames.h"

namespace haptiv {
namespace {

template <typename Options>
auto named(const Options& options, std::string_view name) -> std::optional<typename Options::value_type> {
  for (const auto option : options)
    if (nameOf(option) == name) return option;
  return std::nullopt;
}

}  // namespace

std::string nameOf(DisplayMode mode) {
  switch (mode) {
    case DisplayMode::admittance:
      return "admittance";
    case DisplayMode::positionImpedance:
      return "position-impedance";
    case DisplayMode::impedance:
      return "impedance";
  }
  return "unknown";
}

std::string nameOf(JointController controller) {
  return controller == JointController::pd ? "pd" : "computed-torque";
}

std::string nameOf(OrientationMode mode) {
  return mode == OrientationMode::held ? "held" : "free";
}

std::optional<DisplayMode> displayModeNamed(std::string_view name) {
  return named(kDisplayModes, name);
}

std::optional<JointController> jointControllerNamed(std::string_view name) {
  return named(kJointControllers, name);
}

std::optional<OrientationMode> orientationModeNamed(std::string_view name) {
  return named(kOrientationModes, name);
}

}  // namespace haptiv
