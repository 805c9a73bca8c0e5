#include "haptics/scene/SceneFade.h"

#include <algorithm>

namespace haptiv {

Vector3 SceneFade::apply(const HapticScene& scene, const Vector3& raw, double period) noexcept {
  if (!started || sceneVersion != scene.version) {
    started = true;
    sceneVersion = scene.version;
    bump = felt - raw;
    left = 1;
  }
  felt = raw + left * bump;
  left = std::max(0.0, left - period / kDuration);
  return felt;
}

}  // namespace haptiv
