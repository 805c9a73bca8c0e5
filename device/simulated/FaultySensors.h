#pragma once

#include "device/board/BoardSignals.h"
#include "device/described/DeviceDescription.h"
#include "device/simulated/InjectedFaults.h"

namespace haptiv {

/// Falsifies what the wires say to the board as the injected faults have it.
class FaultySensors {
 public:
  explicit FaultySensors(const HandleSensor& sensor);

  /// @param whole  what a device without faults would say
  /// Realtime-safe: yes.
  BoardInputs falsify(const BoardInputs& whole, const InjectedFaults& faults) noexcept;

 private:
  std::array<std::int16_t, 6> saturated_;
  BoardInputs last_;  // what was said last
};

}  // namespace haptiv
