#pragma once

#include "device/HapticDevice.h"
#include "device/Nonblocking.h"
#include "haptics/tick/HapticTick.h"

namespace haptiv {

/// What every tick does to a device, with a clock (ServoLoop) or without one (FastLoop): read, tick, write.
///
/// @param missedTicks  grid points that were skipped so far
/// @param newestScene  called between read and tick; returns const HapticScene&
/// Realtime-safe: as the device and `newestScene` are.
template <typename NewestScene>
TickRecord serveTick(HapticDevice& device, const HapticTick& tick, NewestScene&& newestScene, TickState& state,
                     std::uint32_t missedTicks = 0) noexcept HAPTIV_NONBLOCKING {
  const DeviceReading reading = device.read();
  const TickRecord record = tick(newestScene(), reading, state, missedTicks);
  device.write(record.command);
  return record;
}

}  // namespace haptiv
