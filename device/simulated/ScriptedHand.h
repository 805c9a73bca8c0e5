#pragma once

#include <vector>

#include "device/simulated/Hand.h"

namespace haptiv {

/// At `time` [s] the hand wants to be at `position` [m]; in which frame, the user of it says. From then on the operator
/// presses `inputs`, OperatorInput bits.
struct HandWaypoint {
  double time = 0;
  Vector3 position = Vector3::Zero();
  std::uint16_t inputs = kInputDeadMan;
};

/// A hand that follows waypoints (in B), in straight lines between them; it holds the last one for ever and
/// has let go before the first one and where there is none.
class ScriptedHand : public HandSource {
 public:
  /// Throws std::runtime_error where the times do not rise or a number is not finite.
  explicit ScriptedHand(std::vector<HandWaypoint> waypoints);
  HandTarget at(double time) noexcept override;

 private:
  std::vector<HandWaypoint> waypoints_;
};

}  // namespace haptiv
