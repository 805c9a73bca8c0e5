#pragma once

#include <memory>

#include "device/described/DeviceDescription.h"
#include "haptics/scene/HapticScene.h"

/// How the redundancy is resolved crosses to the servo, and into the log, with the scene.
namespace haptiv {

/// What is in force: the scene's choice, or else the device description's.
ResolutionChoice resolutionOf(const HapticScene& scene, const DeviceDescription& description);

/// The same scene with this choice.
std::shared_ptr<const HapticScene> withResolution(std::shared_ptr<const HapticScene> scene,
                                                  const std::optional<ResolutionChoice>& choice);

/// Throws std::runtime_error where this arm cannot be resolved so: only VISHARD10 has a partitioned solution.
void expectResolvable(const ResolutionChoice& choice, const DeviceDescription& description);

}  // namespace haptiv
