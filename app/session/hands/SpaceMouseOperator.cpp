#include "app/session/hands/SpaceMouseOperator.h"

#include <chrono>

namespace haptiv {

SpaceMouseOperator::SpaceMouseOperator(const SpaceMouseChoice& choice, const DeviceDescription& description,
                                       const DevicePlacement& placement)
    : arm_(description), R_WB_(placement.rotation), hand_(choice.mode), mouse_(choice.which) {}

SpaceMouseHand::Wish SpaceMouseOperator::wish(const TickRecord& newest, double heading) {
  const Pose X_WT{newest.position, R_WB_ * arm_.forward(newest.jointAngles).rotation};
  const std::int64_t now = std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
  return hand_.follow(mouse_.newest(), now, X_WT, heading);
}

}  // namespace haptiv
