#include "haptics/contact/RememberedBlocks.h"

#include <algorithm>

namespace haptiv {

/// It takes nearly as long as the proxy needs through what is known; then it takes its place.
void RememberedBlocks::lookAhead(const HapticScene& scene, const Vector3& p_W, const Vector3& step, double reach,
                                 double margin) noexcept {
  constexpr double kWhile = 1.5, kToMiddle = 0.9;  // of the margin: gone while it is gathered; from its edge
  constexpr double kFewTicks = 2, kManyTicks = 64;
  const double perTick = std::max(step.norm(), margin / kManyTicks);
  const double ticks = std::max(kWhile * margin / perTick, kFewTicks);
  GatheredBlocks& next = gathered_[1 - now_];
  if (!gathers_) {
    if (known().holds(p_W + (ticks + 2) * step, reach)) return;
    next.start(scene, p_W + (ticks + 1 + kToMiddle * margin / perTick) * step, reach + margin);
    gathers_ = true;
  }
  next.goOn(scene, 1 + known().looks() / static_cast<std::size_t>(ticks - 1));
  if (!next.isComplete() || known().holds(p_W + step, reach)) return;
  now_ = 1 - now_;
  gathers_ = false;
}

}  // namespace haptiv
