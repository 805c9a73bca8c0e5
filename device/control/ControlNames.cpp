#include "device/control/ControlNames.h"

#include "device/NamedOption.h"

namespace haptiv {

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
  return optionNamed(kDisplayModes, name);
}

std::optional<JointController> jointControllerNamed(std::string_view name) {
  return optionNamed(kJointControllers, name);
}

std::optional<OrientationMode> orientationModeNamed(std::string_view name) {
  return optionNamed(kOrientationModes, name);
}

}  // namespace haptiv
