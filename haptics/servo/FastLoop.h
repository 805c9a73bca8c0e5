#pragma once

#include <cstdint>
#include <functional>

#include "device/HapticDevice.h"
#include "haptics/tick/HapticTick.h"

namespace haptiv {

/// The servo loop without thread and clock: as many ticks as asked for, as fast as the machine allows, the same
/// arithmetic as ServoLoop. Times in the records are those of the grid: the same inputs give the same bytes.
///
/// Starts the device and stops it again, also when `sink` throws. Throws what HapticDevice::start and `sink` throw.
///
/// @param rate  ticks per second [Hz]
/// @param sink  gets every record, in order; returns false to end the run
/// @return      number of ticks run
std::uint64_t runFast(HapticDevice& device, const DeviceDescription& description, double rate, const HapticScene& scene,
                      std::uint64_t ticks, const std::function<bool(const TickRecord&)>& sink);

}  // namespace haptiv
