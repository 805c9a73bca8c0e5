#include "device/simulated/ScriptedHand.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace haptiv {

ScriptedHand::ScriptedHand(std::vector<HandWaypoint> waypoints) : waypoints_(std::move(waypoints)) {
  for (std::size_t i = 0; i < waypoints_.size(); ++i) {
    const std::string where = "hand waypoint " + std::to_string(i + 1);
    if (!std::isfinite(waypoints_[i].time) || !waypoints_[i].position.allFinite()) {
      throw std::runtime_error(where + " is not finite; give finite times and places");
    }
    if (i > 0 && waypoints_[i].time <= waypoints_[i - 1].time) {
      throw std::runtime_error(where + " is not later than the one before; let the times rise");
    }
  }
}

HandTarget ScriptedHand::at(double time) noexcept {
  const auto next = std::upper_bound(waypoints_.begin(), waypoints_.end(), time,
                                     [](double t, const HandWaypoint& waypoint) { return t < waypoint.time; });
  if (next == waypoints_.begin()) return {};
  const HandWaypoint& last = *(next - 1);
  if (next == waypoints_.end()) return {true, last.position, last.inputs};
  const double part = (time - last.time) / (next->time - last.time);
  return {true, last.position + part * (next->position - last.position), last.inputs};
}

}  // namespace haptiv
