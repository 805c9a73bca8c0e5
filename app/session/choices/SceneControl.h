#pragma once

#include <memory>

#include "device/described/DeviceDescription.h"
#include "haptics/scene/HapticScene.h"

/// How the arm is driven crosses to the servo, and into the log, with the scene.
namespace haptiv {

/// What is in force: the scene's choice, or else the device description's.
ControlChoice controlOf(const HapticScene& scene, const DeviceDescription& description);

/// The same scene with this choice.
std::shared_ptr<const HapticScene> withControl(std::shared_ptr<const HapticScene> scene,
                                               const std::optional<ControlChoice>& choice);

/// Throws std::runtime_error where this arm cannot be driven so: what is missing, and what to do. Computed torque needs
/// the links' bodies, and the impedance display, which commands torques itself, no joint controller; a device of the
/// impedance type knows that display alone.
void expectControllable(const ControlChoice& choice, const DeviceDescription& description);

}  // namespace haptiv
