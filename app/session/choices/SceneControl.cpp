#include "app/session/choices/SceneControl.h"

#include <stdexcept>
#include <utility>

#include "app/session/choices/WithChoice.h"

namespace haptiv {

ControlChoice controlOf(const HapticScene& scene, const DeviceDescription& description) {
  return scene.control.value_or(description.control.choice);
}

std::shared_ptr<const HapticScene> withControl(std::shared_ptr<const HapticScene> scene,
                                               const std::optional<ControlChoice>& choice) {
  return withChoice(std::move(scene), &HapticScene::control, choice);
}

void expectControllable(const ControlChoice& choice, const DeviceDescription& description) {
  if (choice.display != DisplayMode::impedance && description.type == DeviceType::impedance)
    throw std::runtime_error("the device " + description.name +
                             " has no sensor for the hand's force and no drives that follow rates, so it can only show "
                             "forces: choose impedance");
  if (choice.joints == JointController::computedTorque && description.bodies.links.empty())
    throw std::runtime_error("computed torque needs the links of the arm " + description.name +
                             " as rigid bodies, which its description does not tell: add [[bodies.link]] for each "
                             "joint, see docs/device.md, or choose pd");
}

}  // namespace haptiv
