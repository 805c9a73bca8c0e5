#pragma once

#include <memory>
#include <vector>

#include "app/bench/scenes/WallFloor.h"
#include "device/described/DeviceDescription.h"
#include "device/simulated/ScriptedHand.h"
#include "device/simulated/SimulatedDevice.h"

namespace haptiv {

/// The simulated arm over a floor of small walls, 0.3 m wide if there are 10k, and a hand that presses the ball down
/// and wanders.
class ArmOnFloor {
 public:
  explicit ArmOnFloor(std::uint32_t walls = kWalls);

  static constexpr std::uint32_t kWalls = 10000;
  static constexpr double kRate = 1000;  ///< [Hz]
  const HapticScene& scene() const { return scene_; }
  const DeviceDescription& description() const { return description_; }
  /// Where the hand wants to be, in W.
  std::vector<HandWaypoint> hand() const;
  /// At its start.
  std::unique_ptr<SimulatedDevice> device() const;

 private:
  DeviceDescription description_;
  HapticScene scene_;
};

}  // namespace haptiv
