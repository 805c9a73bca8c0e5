#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "haptics/scene/HapticScene.h"

namespace haptiv {

/// The same scene with this choice of the operator's. @param which  of the scene's choices
template <typename Choice>
std::shared_ptr<const HapticScene> withChoice(std::shared_ptr<const HapticScene> scene,
                                              std::optional<Choice> HapticScene::*which,
                                              const std::optional<Choice>& choice) {
  if ((*scene).*which == choice) return scene;
  HapticScene chosen = *scene;
  chosen.*which = choice;
  return std::make_shared<const HapticScene>(std::move(chosen));
}

}  // namespace haptiv
