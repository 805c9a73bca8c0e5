#include "app/session/choices/SceneResolution.h"

#include <stdexcept>
#include <utility>

#include "app/session/choices/WithChoice.h"

namespace haptiv {

ResolutionChoice resolutionOf(const HapticScene& scene, const DeviceDescription& description) {
  return scene.resolution.value_or(description.redundancy.choice);
}

std::shared_ptr<const HapticScene> withResolution(std::shared_ptr<const HapticScene> scene,
                                                  const std::optional<ResolutionChoice>& choice) {
  return withChoice(std::move(scene), &HapticScene::resolution, choice);
}

void expectResolvable(const ResolutionChoice& choice, const DeviceDescription& description) {
  if (choice.solution == Solution::partitioned && !description.isVishard10())
    throw std::runtime_error("the arm " + description.name +
                             " has no partitioned solution: only VISHARD10's position and orientation come apart; "
                             "choose the full one");
}

}  // namespace haptiv
